// Somebody who draws by chance, presses, types and removes; and steps back and forth through all of it.
const canvas = document.getElementById('mechanism');
canvas.setPointerCapture = () => {};
const frame = () => new Promise((then) => requestAnimationFrame(then));
let seed = 20261123;
const below = (limit) => {
  seed ^= seed << 13; seed ^= seed >>> 17; seed ^= seed << 5;
  return (seed >>> 0) % limit;
};
const pointer = (type, x, y) => canvas.dispatchEvent(new PointerEvent(type, {
  clientX: x, clientY: y, button: 0, pointerId: 7, pointerType: 'mouse', bubbles: true, cancelable: true,
}));
const errors = [];
addEventListener('error', ({ message }) => errors.push(message));
const fields = () => [...document.querySelectorAll('#draw-points input')];
const shown = () => fields().map(({ id, value }) => id + value).join() + document.getElementById('draw-reasons').textContent;
const tools = ['bars', 'bars', 'plate', 'slide', 'fix', 'fix', 'drive', 'dyad', 'triad', 'wheel', 'mesh', 'tracer', 'mass'];
const place = () => {
  const box = canvas.getBoundingClientRect();
  return [box.x + 60 + below(box.width - 120), box.y + 130 + below(Math.max(box.height - 200, 1))];
};
const press = () => {
  const [x, y] = place();
  pointer('pointerdown', x, y);
  pointer('pointerup', x, y);
};
const type = () => {
  const all = fields();
  if (all.length === 0) return;
  const field = all[below(all.length)];
  field.focus();
  field.value = String((below(2000) - 1000) / 100);
  field.dispatchEvent(new Event('input', { bubbles: true }));
  field.dispatchEvent(new Event('change', { bubbles: true }));
  field.blur();
};
const remove = () => {
  document.getElementById('draw-select').click();
  const [from, to] = [place(), place()];
  pointer('pointerdown', ...from);
  pointer('pointermove', (from[0] + to[0]) / 2, (from[1] + to[1]) / 2);
  pointer('pointermove', ...to);
  pointer('pointerup', ...to);
  document.body.dispatchEvent(new KeyboardEvent('keydown', { key: 'Delete', bubbles: true, cancelable: true }));
};
let before = shown();

// So many edits by chance, some of which are one step with the one before.
const edit = async (count) => {
  let [edits, tries] = [0, 0];
  while (edits < count && tries < 8 * count) {
    tries += 1;
    const what = below(10);
    if (fields().length > 44) remove();
    else if (what < 4) type();
    else {
      if (what < 8) document.getElementById('draw-' + tools[below(tools.length)]).click();
      press();
    }
    await frame();
    const now = shown();
    if (now !== before) edits += 1;
    before = now;
  }
  return edits;
};

// What is shown is kept at once.
const address = () => {
  dispatchEvent(new Event('pagehide'));
  return location.hash;
};

// So many steps, slowly enough for a browser to take an address for each.
const walk = async (id, count) => {
  const button = document.getElementById(id);
  const addresses = [];
  while (!button.disabled && addresses.length < count) {
    button.click();
    await new Promise((then) => setTimeout(then, 52));
    addresses.push(address());
  }
  return { addresses, over: button.disabled };
};

window.chance = { edit, address, walk, errors };
