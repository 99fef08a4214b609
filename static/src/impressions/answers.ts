// What the analysis of stability and the comparison answer.
import type { Cluster, Pair } from "./model";

export interface Stability {
  samples: number;
  seed: number;
  pairs: { id: string; kept: number }[];
  clusters: { key: string; title: string; overlap: number }[];
  rand_mean: number;
  rand_low: number;
  rand_high: number;
  by_participants: { participants: number; mean: number; low: number; high: number }[];
  sentence: string;
}

export interface Comparison {
  here: string;
  there: string;
  shared: number;
  rand: number | null;
  together: Record<string, string>;
  here_clusters: Cluster[];
  there_clusters: Cluster[];
  moved: (Pick<Pair, "id" | "left" | "right"> & { here: string | null; there: string | null })[];
  sentence: string;
}
