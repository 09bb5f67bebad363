// What a barrier design says of all lines: the factors of the check with their sources, and lines in pairs.

import { results, type AppliedFactor, type DesignPair, type PairKit } from '../api/results';
import type { Run } from '../api/types';
import { DataTable } from '../charts/DataTable';
import { useRemote } from '../ui/remote';
import { fileName } from '../charts/save';

const kitText = ({ kit, height_m, energy_J }: PairKit) =>
  `${kit === null ? '' : `${kit}, `}${height_m} m, ${Number(energy_J) / 1000} kJ`;

function Pairs({ run, pairs }: { run: Run; pairs: readonly DesignPair[] }) {
  const isStaggered = pairs.some(({ overlap_m }) => overlap_m !== null);
  return (
    <DataTable
      caption="Two lines, one behind the other"
      file={fileName(run.name, 'design_pairs')}
      hasHeads
      columns={[
        { key: 'first', title: 'First line', isText: true },
        { key: 'first_kit', title: 'Its kit', isText: true },
        { key: 'second', title: 'Second line', isText: true },
        { key: 'second_kit', title: 'Its kit', isText: true },
        { key: 'caught_share', title: 'Share caught' },
        { key: 'caught_by_first', title: 'By the first' },
        { key: 'at_second', title: 'Go on to the second' },
        { key: 'caught_by_second', title: 'By the second' },
        { key: 'beside', title: 'Beyond the ends of both' },
        ...(isStaggered
          ? [
              { key: 'overlap_m', title: 'Overlap', unit: 'm' },
              { key: 'needs_overlap_m', title: 'Needs', unit: 'm' },
            ]
          : []),
        { key: 'suffices', title: 'Suffices', isText: true },
        { key: 'cost', title: 'Cost' },
      ]}
      rows={pairs.map((pair) => [
        pair.first.line,
        kitText(pair.first),
        pair.second.line,
        kitText(pair.second),
        pair.caught_share?.value ?? '',
        pair.caught_by_first,
        pair.at_second,
        pair.caught_by_second,
        pair.beside,
        ...(isStaggered ? [pair.overlap_m ?? '', pair.needs_overlap_m ?? ''] : []),
        pair.suffices ? 'yes' : 'no',
        pair.cost,
      ])}
    />
  );
}

function Factors({ run, standard, factors }: { run: Run; standard: string; factors: readonly AppliedFactor[] }) {
  return (
    <DataTable
      caption={`Factors of the check of ${standard}`}
      file={fileName(run.name, 'factors')}
      hasHeads
      columns={[
        { key: 'symbol', title: 'Symbol', isText: true },
        { key: 'key', title: 'Key', isText: true },
        { key: 'multiplies', title: 'Multiplies', isText: true },
        { key: 'value', title: 'Value' },
        { key: 'source', title: 'Source', isText: true },
        { key: 'not_read', title: 'Could not be read there', isText: true },
      ]}
      rows={factors.map((f) => [f.symbol, f.key, f.multiplies, f.value, f.source, f.not_read])}
    />
  );
}

export function DesignSummary({ run }: { run: Run }) {
  const design = useRemote(run.id, String(run.done), (signal) => results.summary(run.id, signal)).value?.design;
  if (!design) return null;
  return (
    <div class="design">
      {design.pairs && design.pairs.length > 0 && <Pairs run={run} pairs={design.pairs} />}
      {design.applied_factors && design.applied_factors.length > 0 && (
        <Factors run={run} standard={design.standard ?? ''} factors={design.applied_factors} />
      )}
    </div>
  );
}
