// SPDX-License-Identifier: GPL-3.0-or-later
// What the page takes for an agent's beliefs, held against what the log says: bit for bit.
import { readFileSync } from 'node:fs';
import { normalise } from '../../sim/viewer/src/model/data';
import { jsonOf } from '../../sim/viewer/src/model/decode';
import { ViewModel } from '../../sim/viewer/src/model/view_model';

interface Expected { agent: number; t_s: number; winners: number[]; bids: (number | null)[] }

const [dataFile, expectFile] = process.argv.slice(2);

function firstDifference(model: ViewModel, { agent, t_s, winners, bids }: Expected): string | undefined {
  const held = model.beliefs(agent, t_s);
  if (winners.length !== model.tasks.length || bids.length !== winners.length)
    return `${winners.length} winners and ${bids.length} bids are expected of ${model.tasks.length} tasks`;
  for (const [slot, { task }] of model.tasks.entries()) {
    if (held.winners[slot] !== winners[slot]) return `task ${task}: winner ${held.winners[slot]}, expected ${winners[slot]}`;
    // Nobody's bid is nothing: null in JSON, not a number here.
    if (!Object.is(held.bids[slot], bids[slot] ?? NaN)) return `task ${task}: bid ${held.bids[slot]}, expected ${bids[slot]}`;
  }
  return undefined;
}

async function check(): Promise<number> {
  const model = new ViewModel(normalise(await jsonOf(new Uint8Array(readFileSync(dataFile)))));
  const expected = JSON.parse(readFileSync(expectFile, 'utf8')) as Expected[];
  for (const one of expected) {
    const difference = firstDifference(model, one);
    if (difference === undefined) continue;
    console.error(`${dataFile}: agent ${one.agent} at ${one.t_s} s: ${difference}`);
    return 1;
  }
  if (expected.length === 0) console.error(`${expectFile}: expects nothing`);
  else console.log(`${expected.length} tables of beliefs are as expected`);
  return expected.length === 0 ? 1 : 0;
}

process.exitCode = await check();
