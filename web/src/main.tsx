import { render } from 'preact';

render(<h1>Talus</h1>, document.getElementById('page')!);
