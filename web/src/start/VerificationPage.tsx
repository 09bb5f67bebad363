// The published cases compared with the results of this program.

import { useEffect, useState } from 'preact/hooks';
import { api } from '../api/client';
import type { Verification, VerificationCase } from '../api/types';
import { reportFailure } from '../state/messages';
import { numberText } from '../units/numbers';

export function VerificationPage({ close }: { close: () => void }) {
  const [answer, setAnswer] = useState<Verification | null>(null);
  useEffect(() => void api.verification().then(setAnswer, reportFailure), []);
  return (
    <main class="start">
      <header>
        <div>
          <h1>Verification</h1>
          <p class="faint">
            The cases of Rocscience's RocFall3 verification manual, and blocks whose motion is known, computed now by
            this program and compared with the printed numbers.
          </p>
        </div>
        <button class="button" onClick={close}>
          ‹ Start page
        </button>
      </header>
      {!answer && <p role="status">Computing. This takes some seconds…</p>}
      {answer && (
        <>
          <p class={answer.passes ? 'verdict good' : 'verdict bad'} role="status">
            {answer.passes ? 'All numbers agree within their tolerances.' : 'Some numbers are outside their tolerances.'}
          </p>
          {answer.cases.map((one) => (
            <Case key={one.case} one={one} />
          ))}
        </>
      )}
    </main>
  );
}

function Case({ one }: { one: VerificationCase }) {
  return (
    <details class="case" open={!one.passes}>
      <summary>
        <span class="name">{one.title}</span>
        <span class={one.passes ? 'good' : 'bad'}>
          {one.agree.toLocaleString('en')} of {one.compared.toLocaleString('en')} numbers agree
        </span>
      </summary>
      {one.tables.map((table) => (
        <Table key={`${table.title} ${table.run}`} table={table} />
      ))}
    </details>
  );
}

function Table({ table }: { table: VerificationCase['tables'][number] }) {
  const [open, setOpen] = useState(false);
  const verdict = table.differ === 0 ? `${table.agree} agree` : `${table.agree} agree, ${table.differ} do not`;
  return (
    <details class="table" onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>
        {[table.title, table.source, table.run].filter(Boolean).join(', ')}{' '}
        <span class={table.differ === 0 ? 'good' : 'bad'}>{verdict}</span>
      </summary>
      <p class="faint">{table.why}</p>
      {open && (
        <div class="scroll">
          <table>
            <thead>
              <tr>
                <th scope="col">Row</th>
                <th scope="col">Quantity</th>
                <th scope="col">Published</th>
                <th scope="col">Talus</th>
                <th scope="col">Difference</th>
                <th scope="col">Allowed</th>
                <th scope="col">Verdict</th>
              </tr>
            </thead>
            <tbody>
              {table.numbers.map((number, k) => (
                <tr key={k} class={number.verdict === 'differs' ? 'bad' : ''}>
                  <td>{number.row}</td>
                  <td>{number.quantity}</td>
                  <td class="number">{number.published}</td>
                  <td class="number">{number.talus}</td>
                  <td class="number">{numberText(number.difference, 3)}</td>
                  <td class="number">{number.allowed}</td>
                  <td>{number.verdict}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
    </details>
  );
}
