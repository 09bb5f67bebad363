import { edit, values } from '../project/document';
import { defaultOf } from '../settings/names';
import { TableForm } from './fields/TableForm';

/// The barrier design, which is optional: it is made if the project has its table.
export function DesignForm() {
  if (values.value.design === undefined)
    return (
      <div class="row">
        <button
          class="button first"
          onClick={() => edit('add a barrier design', [{ set: ['design', 'standard'], value: defaultOf('design', 'standard') }])}
        >
          Add a barrier design to every run
        </button>
      </div>
    );
  return (
    <>
      <div class="row">
        <button class="button danger" onClick={() => edit('remove the barrier design', [{ remove: ['design'] }])}>
          Remove the barrier design
        </button>
      </div>
      <TableForm table="design" path={['design']} />
    </>
  );
}
