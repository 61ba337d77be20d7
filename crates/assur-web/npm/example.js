// Prints the values of a mechanism of the catalogue at a crank angle in degrees: `node example.js jansen 30`
import { Mechanism } from "assur";

const [, , id = "jansen", degrees = "30"] = process.argv;
const mechanism = Mechanism.named(id);
const { readouts } = mechanism.pose((Number(degrees) * Math.PI) / 180);
console.log(JSON.stringify(readouts, null, 2));
