// Every text of a study that participants read, found by the descriptions of its fields.
import { CONSENT, fieldsOf, THANKS, WELCOME, type Field } from "./fields";
import { at, isObj, languagesOf, listOf, objOf, partsOf, textOf, type Json, type Language, type Path } from "./model";

export interface Text {
  path: Path;
  words: Json;
}

export function textsOf(study: Json): Text[] {
  const parts = partsOf(study).flatMap((part, index) => texts(study, fieldsOf(part), ["parts", index]));
  return [...texts(study, [...WELCOME, ...CONSENT], []), ...parts, ...texts(study, THANKS, [])];
}

/** The texts that have no wording of their own in a language; the first language's is shown instead. */
export function missingIn(study: Json, language: Language): Text[] {
  const [first] = languagesOf(study);
  if (language === first) return [];
  return textsOf(study).filter(({ words }) => (isObj(words) ? !textOf(words[language]) : Boolean(words)));
}

function texts(study: Json, fields: readonly Field[], base: Path): Text[] {
  const whole = objOf(at(study, base));
  return fields.filter(({ when }) => when?.(whole) ?? true).flatMap((field) => {
    const path = [...base, ...field.at.split(".")];
    const value = at(study, path);
    if (value === undefined || value === null) return [];
    switch (field.type) {
      case "words":
        return [{ path, words: value }];
      case "lines":
        return listOf(value).map((words, index) => ({ path: [...path, index], words }));
      case "list":
        return listOf(value).flatMap((_, index) => texts(study, field.rows, [...path, index]));
      case "group":
        return texts(study, field.fields, path);
      case "checks":
        return listOf(value).flatMap((check, index) => {
          const words = at(check, ["text"]);
          return words === undefined ? [] : [{ path: [...path, index, "text"], words }];
        });
      default:
        return [];
    }
  });
}
