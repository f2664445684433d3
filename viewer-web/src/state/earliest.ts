// The ends of a list of moments [ns] without an order. Both are undefined for an empty list.

export const earliest = (moments: readonly bigint[]): bigint | undefined =>
  moments.reduce<bigint | undefined>(
    (first, moment) => (first === undefined || moment < first ? moment : first),
    undefined,
  );

export const latest = (moments: readonly bigint[]): bigint | undefined =>
  moments.reduce<bigint | undefined>(
    (last, moment) => (last === undefined || moment > last ? moment : last),
    undefined,
  );
