import { lengths, rows } from "./example.mjs";

// The table's terms: how many each class keeps of each product, and a row of coefficients for each of them.
const terms = { lengths, rows };
export const readTerms = () => terms;
