import { expect, test } from 'vitest';
import { counted, fixedText, measured, numberText, tickText } from './numbers';

test('a number has the given number of significant digits', () => {
  const shown = [0, 12, 1234567, 1234.5, 98.7654321, 0.00123456, -2.5, 1.23456e-7, 3e20, NaN].map((value) =>
    numberText(value),
  );
  expect(shown).toEqual(['0', '12', '1,234,567', '1,235', '98.77', '0.001235', '−2.5', '1.235e−7', '3e+20', '–']);
  expect(numberText(98.7654321, 6)).toBe('98.7654');
});

test('a result has at most three decimals, or one significant digit if it is smaller', () => {
  const values = [0.9822534, 375.9585, 1879792.2, 12.5, 4, 0.000293506, 1.3677e-14, -0.0338, NaN];
  expect(values.map((value) => measured(value))).toEqual('0.982 376 1,879,792 12.5 4 0.0003 0 −0.034 –'.split(' '));
  expect(measured(12.3456, 3)).toBe('12.3');
});

test('axis labels have the decimals of the tick interval', () => {
  expect([0, 0.5, 1].map((value) => tickText(value, 0.5))).toEqual(['0.0', '0.5', '1.0']);
  expect([-2000, 2667000].map((value) => tickText(value, 1000))).toEqual(['−2,000', '2,667,000']);
  expect(tickText(-1e-17, 0.1)).toBe('0.0');
  expect(fixedText(2.345, 1)).toBe('2.3');
});

test('counts are singular or plural', () => {
  expect(counted(1, 'rock')).toBe('1 rock');
  expect(counted(1234, 'rock')).toBe('1,234 rocks');
  expect(counted(2, 'vertex', 'vertices')).toBe('2 vertices');
});
