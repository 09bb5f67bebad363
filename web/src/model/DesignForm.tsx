import { edit, values } from '../state/document';
import { defaultOf } from './names';
import { TableForm } from './form/TableForm';

/// The design of barriers, which is made only where the project has its table.
export function DesignForm() {
  if (values.value.design === undefined)
    return (
      <div class="row">
        <button
          class="button first"
          onClick={() => edit('make a barrier design', [{ set: ['design', 'standard'], value: defaultOf('design', 'standard') }])}
        >
          Make a design with every run
        </button>
      </div>
    );
  return (
    <>
      <div class="row">
        <button class="button danger" onClick={() => edit('leave the barrier design out', [{ remove: ['design'] }])}>
          Make no design
        </button>
      </div>
      <TableForm table="design" path={['design']} />
    </>
  );
}
