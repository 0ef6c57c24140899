// SPDX-License-Identifier: GPL-3.0-or-later
// How the page gets its run: out of itself, or from where it was served, again and again while it lasts.
import { normalise, type RunData } from './model/data';
import { bytesOf, jsonOf } from './model/decode';

export async function embedded(): Promise<RunData | undefined> {
  const element = document.getElementById('arcbid-data');
  if (!element) return undefined;
  return normalise(await jsonOf(bytesOf((element.textContent ?? '').trim())));
}

export async function served(): Promise<RunData> {
  if (location.protocol === 'file:')
    throw new Error('This page holds no run. "arcbid report RUN" writes one that does; "arcbid view RUN" serves it.');
  const answer = await fetch('data', { cache: 'no-store' });
  if (!answer.ok) throw new Error(`data: the server says ${answer.status} ${answer.statusText}`);
  return normalise(await jsonOf(new Uint8Array(await answer.arrayBuffer())));
}

export type Liveness = 'live' | 'lost' | 'ended';

/**
 * Tells of each new version once it is here. While one is fetched, newer ones wait: only the
 * newest of them is fetched then.
 */
export function follow(arrived: (data: RunData) => void, state: (liveness: Liveness) => void): void {
  const source = new EventSource('updates');
  let fetching = false, again = false, ended = false;
  const fetchNew = async (): Promise<void> => {
    if (fetching) { again = true; return; }
    fetching = true;
    try {
      do {
        again = false;
        arrived(await served());
      } while (again);
      if (ended) state('ended');
    } catch {
      state('lost');
    } finally {
      fetching = false;
    }
  };
  // Whatever was missed before the line was up, or while it was down, is in what is fetched now.
  source.onopen = () => { state('live'); void fetchNew(); };
  source.onerror = () => { if (!ended) state('lost'); };
  source.onmessage = (event) => {
    ended = (JSON.parse(event.data as string) as { ended?: boolean }).ended === true;
    if (ended) source.close();
    void fetchNew();
  };
}
