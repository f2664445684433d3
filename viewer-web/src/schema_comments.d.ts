// Made by schema_comments.mjs when the viewer is built.
declare module "virtual:schema_comments" {
  /** By full name of the message and name of the field: its unit, and what it is. */
  const comments: Record<string, Record<string, [unit: string, comment: string]>>;
  export default comments;
}
