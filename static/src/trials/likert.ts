// One moving figure, several statements to agree with.

import { ofItems } from "./items";

export const likert = ofItems(1, "bipolar", "item id to step, 1 the lowest");
