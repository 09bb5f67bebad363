import { isOverdue } from '../api/patience';
import { dismiss, messages } from '../state/messages';

export function Messages() {
  return (
    <div class="messages" role="status" aria-live="polite">
      {isOverdue.value && (
        <div class="note">
          <span>
            Still waiting for the server. If this continues, check that talus serve is running. Nothing is lost.
          </span>
        </div>
      )}
      {messages.value.map(({ id, kind, text }) => (
        <div key={id} class={kind}>
          <span>{text}</span>
          <button class="button plain icon" aria-label="Dismiss" onClick={() => dismiss(id)}>
            ✕
          </button>
        </div>
      ))}
    </div>
  );
}
