// The comments of the schemas' fields for the viewer: descriptors on the wire carry no comments.
//
// A plugin for Vite: `import comments from "virtual:schema_comments"` gives {message: {field: [unit, comment]}}.

import { protoFiles, schemaOfFiles } from "./schema.mjs";

/** Returns unit and comment of each field that has a comment, by message and field. */
export function commentsOf({ messages }) {
  const told = messages.map(({ name, fields }) => [
    name,
    Object.fromEntries(fields.filter(({ remark }) => remark).map(({ name, unit, comment }) => [name, [unit, comment]])),
  ]);
  return Object.fromEntries(told.filter(([, fields]) => Object.keys(fields).length > 0));
}

export function schemaComments(folder) {
  const id = "virtual:schema_comments";
  return {
    name: "schema-comments",
    resolveId: (source) => (source === id ? `\0${id}` : undefined),
    load(source) {
      if (source !== `\0${id}`) return undefined;
      const files = protoFiles(folder);
      for (const file of files) this.addWatchFile?.(file);
      return `export default ${JSON.stringify(commentsOf(schemaOfFiles(files)))};`;
    },
  };
}
