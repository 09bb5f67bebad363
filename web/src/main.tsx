import { render } from 'preact';
import { App } from './page/App';
import './page/theme.css';
import './page/workbench.css';
import './view/theme';

render(<App />, document.getElementById('page')!);
