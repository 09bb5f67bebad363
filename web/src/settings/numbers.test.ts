import { describe, expect, test } from 'vitest';
import { numberOf, typedList, typedNumber, typedValue } from './numbers';

describe('typed numbers', () => {
  test.each([
    ['1', 1],
    [' 0.35 ', 0.35],
    ['.5', 0.5],
    ['5.', 5],
    ['-1e-3', -0.001],
    ['+2', 2],
    ['\u22123', -3],
    ['inf', Infinity],
    ['9007199254740993', 9007199254740993n],
    ['-9223372036854775808', -(2n ** 63n)],
    ['1e-300', 1e-300],
    ['0e5', 0],
  ])('%s', (text, value) => expect(numberOf(text)).toBe(value));
  test.each(['', '-', '0,8', '1e', 'abc', '1 2', '0x10', 'Infinity', 'NaN'])('"%s" is not a number', (text) =>
    expect(numberOf(text)).toBeUndefined(),
  );
  const lost = ['1e999', '-1e999', '1e-999', '9223372036854775808', '99999999999999999999'];
  test.each(lost)('%s cannot be represented', (text) => {
    expect(numberOf(text)).toBeUndefined();
    expect(typedValue(text)).toBe(text);
  });
  test('a text that is not a number is passed on unchanged', () => {
    expect(typedValue('0,8')).toBe('0,8');
    expect(typedValue('  ')).toBeUndefined();
  });
});

describe('the field of a number accepts a decimal comma', () => {
  test.each([
    ['0,35', 0.35],
    ['-0,8', -0.8],
    ['\u22120,8', -0.8],
    ['12,5', 12.5],
    ['0,350', 0.35],
    ['1234,5', 1234.5],
    ['1,2345', 1.2345],
    [',5', 0.5],
    ['2,', 2],
    ['1,5e3', 1500],
    ['0.35', 0.35],
    ['inf', Infinity],
  ])('%s', (text, value) => expect(typedNumber(text)).toBe(value));
  test.each(['1,250', '-1,250', '1,2,3', '1,234.5', '1.234,5', '0,5 0,6', ',', 'a,b'])('"%s" is passed on unchanged', (text) =>
    expect(typedNumber(text)).toBe(text),
  );
  test('an empty field has no value', () => expect(typedNumber(' ')).toBeUndefined());
});

describe('typed lists', () => {
  test.each([
    ['50, 95, 97.5', [50, 95, 97.5]],
    ['50,95', [50, 95]],
    ['50;95 99', [50, 95, 99]],
    ['50, 97,5', [50, '97,5']],
    ['2,5; 3,5', ['2,5', '3,5']],
    ['2,5 3', ['2,5', 3]],
    ['0.5 ,5', [0.5, 5]],
    [' , ', []],
  ])('%s', (text, list) => expect(typedList(text)).toEqual(list));
});
