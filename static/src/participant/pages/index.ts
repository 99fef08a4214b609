// Every kind of page between the trials, by the name that a study file gives it.

import type { AnyKind } from "../../trials";
import { comment } from "./comment";
import { form } from "./form";
import { reading } from "./reading";

export const pages: Readonly<Record<string, AnyKind>> = {
  form,
  instructions: reading,
  break: reading,
  comment,
  debriefing: reading,
};
