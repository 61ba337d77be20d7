//! Typed indices of links, points, bodies, steps and slides. The types are not interchangeable, and an index is valid
//! only for the mechanism that gave it.

use std::fmt;
use std::marker::PhantomData;
use std::ops::{Index, IndexMut};

pub(crate) trait Id: Copy {
    fn at(index: usize) -> Self;
    fn number(self) -> usize;
}

macro_rules! ids {
    ($($(#[$attribute:meta])* $seen:vis $name:ident)*) => {$(
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        $seen struct $name(usize);

        impl Id for $name {
            #[inline(always)]
            fn at(index: usize) -> Self {
                Self(index)
            }

            #[inline(always)]
            fn number(self) -> usize {
                self.0
            }
        }
    )*};
}

ids! {
    /// Index of a moving link, in the order of the specification.
    pub LinkId
    /// Index of a point, in the order of the specification.
    pub PointId
    /// Index of a rigid body: the frame or a link, together with the links fixed to it.
    pub BodyId
    /// Index of a step of the plan that solves a mechanism. A step is a driver or a group.
    pub StepId
    /// Index of a prismatic pair, in the order of the specification.
    pub SlideId
}

macro_rules! places {
    ($($name:ident)*) => {$(
        impl $name {
            /// The index, from 0.
            #[inline(always)]
            pub fn index(self) -> usize {
                self.0
            }
        }
    )*};
}

places! { LinkId PointId BodyId StepId SlideId }

impl BodyId {
    /// The frame.
    pub const FRAME: Self = Self(0);
}

impl StepId {
    /// The first step. It stands for the whole plan if a failure concerns no single step.
    pub(crate) const FIRST: Self = Self(0);
}

/// A list with typed indices.
pub(crate) struct List<I, T> {
    items: Vec<T>,
    numbers: PhantomData<I>,
}

impl<I: Id, T> List<I, T> {
    pub(crate) fn len(&self) -> usize {
        self.items.len()
    }

    pub(crate) fn ids(
        &self,
    ) -> impl DoubleEndedIterator<Item = I> + ExactSizeIterator + Clone + use<I, T> {
        (0..self.len()).map(I::at)
    }

    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = &T> + DoubleEndedIterator + Clone {
        self.items.iter()
    }

    pub(crate) fn iter_mut(&mut self) -> impl Iterator<Item = &mut T> {
        self.items.iter_mut()
    }

    pub(crate) fn enumerate(&self) -> impl Iterator<Item = (I, &T)> {
        self.ids().zip(&self.items)
    }

    pub(crate) fn push(&mut self, item: T) -> I {
        self.items.push(item);
        I::at(self.items.len() - 1)
    }

    pub(crate) fn remove(&mut self, id: I) -> T {
        self.items.remove(id.number())
    }

    /// A list with the same indices as this one, filled with copies of an item.
    pub(crate) fn same_len<U: Clone>(&self, item: U) -> List<I, U> {
        vec![item; self.len()].into()
    }
}

impl<I: Id, T> Index<I> for List<I, T> {
    type Output = T;
    #[inline(always)]
    fn index(&self, id: I) -> &T {
        &self.items[id.number()]
    }
}

impl<I: Id, T> IndexMut<I> for List<I, T> {
    #[inline(always)]
    fn index_mut(&mut self, id: I) -> &mut T {
        &mut self.items[id.number()]
    }
}

impl<I, T> From<Vec<T>> for List<I, T> {
    fn from(items: Vec<T>) -> Self {
        let numbers = PhantomData;
        Self { items, numbers }
    }
}

impl<I, T> FromIterator<T> for List<I, T> {
    fn from_iter<A: IntoIterator<Item = T>>(items: A) -> Self {
        Vec::from_iter(items).into()
    }
}

impl<I, T> Default for List<I, T> {
    fn default() -> Self {
        Vec::new().into()
    }
}

impl<I, T: Clone> Clone for List<I, T> {
    fn clone(&self) -> Self {
        self.items.clone().into()
    }
}

impl<I, T: PartialEq> PartialEq for List<I, T> {
    fn eq(&self, other: &Self) -> bool {
        self.items == other.items
    }
}

impl<I, T: fmt::Debug> fmt::Debug for List<I, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.items.fmt(f)
    }
}
