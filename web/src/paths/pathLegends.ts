// The legends of the trajectories.

import { arePathsShown } from '../maps/over';
import { isOutdated } from '../runs/outdated';
import { compared, shown } from '../runs/runs';
import { counted } from '../units/numbers';
import { stopsOf, type LegendData } from '../view/legends';
import { runColour } from '../view/theme';
import { colouring } from './colouring';
import { shownPaths } from './drawnPaths';
import { leftByFilter } from './shownPassing';

export function pathLegends(): LegendData[] {
  const how = colouring.value;
  if (!how || !arePathsShown.value) return [];
  const list: LegendData[] = [];
  if (how.kind === 'run') {
    const kinds = [
      { name: shown.value?.name ?? '', colour: how.colour },
      { name: compared.value?.name ?? '', colour: runColour('compared') },
    ];
    list.push({ kind: 'kinds', title: 'Trajectories of two runs', kinds });
  } else if (how.kind === 'scale') {
    const { title, per, isClipped } = how;
    list.push({ kind: 'scale', title, stops: stopsOf(how.ramp), low: how.low / per, high: how.high / per, isClipped });
  } else {
    const kinds = how.names.map((name, k) => ({ name, colour: how.colours[k]! })).filter((_, k) => how.isUsed[k]);
    list.push({ kind: 'kinds', title: how.title, kinds });
  }
  const count = leftByFilter.value;
  const left = count && `${count.left.toLocaleString('en')} of ${counted(count.of, 'trajectory', 'trajectories')}`;
  if (left) list.push({ kind: 'remark', text: left, isWarning: false });
  const soFar = shownPaths.value?.header.so_far;
  if (soFar) list.push({ kind: 'remark', text: `In progress: ${soFar.done.toLocaleString('en')} of ${counted(soFar.planned, 'rock')}`, isWarning: true });
  if (isOutdated.value) list.push({ kind: 'remark', text: 'Trajectories from an earlier version of the project', isWarning: true });
  return list;
}
