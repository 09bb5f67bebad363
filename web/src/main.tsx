import { render } from 'preact';
import { App } from './app';
import './ui/theme.css';
import './ui/workbench.css';
import './view/theme';

render(<App />, document.getElementById('page')!);
