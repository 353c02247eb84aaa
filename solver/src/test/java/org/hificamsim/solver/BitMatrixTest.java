package org.hificamsim.solver;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.BitSet;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BitMatrixTest {
  private static final int ROWS = 5;

  @ParameterizedTest
  @ValueSource(ints = {1, 63, 64, 65, 200})
  void rowsEqualSetsOfColumns(int columns) {
    SplittableRandom random = new SplittableRandom(columns);
    BitSet[] sets = new BitSet[ROWS];
    BitMatrix matrix = new BitMatrix(ROWS, columns);
    for (int row = 0; row < ROWS; row++) {
      sets[row] = randomSet(random, columns);
      matrix.setRow(row, Arrays.copyOf(sets[row].toLongArray(), matrix.words()), 0);
    }
    for (int row = 0; row < ROWS; row++) {
      BitSet set = sets[row];
      BitMatrix one = new BitMatrix(1, columns);
      set.stream().forEach(column -> one.set(0, column));
      assertEquals(set.cardinality(), matrix.count(row));
      assertArrayEquals(set.stream().toArray(), matrix.columns(row));
      for (int other = 0; other < ROWS; other++) {
        checkPair(matrix, row, other, set, sets[other]);
        BitSet missing = (BitSet) sets[other].clone();
        missing.andNot(set);
        assertEquals(missing.isEmpty(), matrix.includes(row, other));
      }
      for (int column = 0; column < columns; column++) {
        assertEquals(set.get(column), matrix.has(row, column));
        assertEquals(set.get(column), one.has(0, column));
      }
    }
  }

  /** Compares what two rows make with what their sets make. */
  private static void checkPair(BitMatrix matrix, int row, int other, BitSet set, BitSet otherSet) {
    BitSet common = (BitSet) set.clone();
    common.and(otherSet);
    BitSet union = (BitSet) set.clone();
    union.or(otherSet);
    BitSet rest = (BitSet) set.clone();
    rest.andNot(otherSet);
    BitMatrix result = new BitMatrix(3, Long.SIZE * matrix.words());
    for (int copy = 0; copy < 3; copy++) {
      result.setRow(copy, matrix, row);
    }
    assertEquals(!common.isEmpty(), result.intersect(0, matrix, other));
    result.unite(1, matrix, other);
    result.subtract(2, matrix, other);
    assertArrayEquals(common.stream().toArray(), result.columns(0));
    assertArrayEquals(union.stream().toArray(), result.columns(1));
    assertArrayEquals(rest.stream().toArray(), result.columns(2));
    assertEquals(common.cardinality(), matrix.countCommon(row, matrix, other));
  }

  @Test
  void widenedMatrixAndItsRowsKeepColumns() {
    BitMatrix matrix = new BitMatrix(2, 64);
    matrix.set(0, 63);
    matrix.set(1, 5);
    BitMatrix wider = matrix.widened(200);
    wider.set(0, 199);
    assertArrayEquals(new int[] {63, 199}, wider.columns(0));
    assertArrayEquals(new int[] {5}, wider.columns(1));
    assertArrayEquals(new int[] {63}, wider.row(0, 64).columns(0));
  }

  @Test
  void addsToCountsAndSumsValuesOfColumns() {
    BitMatrix matrix = new BitMatrix(1, 130);
    for (int column : new int[] {0, 63, 64, 129}) {
      matrix.set(0, column);
    }
    int[] counts = new int[130];
    long[] values = IntStream.range(0, 130).asLongStream().toArray();
    matrix.add(0, counts, 2);
    assertEquals(63 + 64 + 129, matrix.sum(0, values));
    assertEquals(63, matrix.row(0, 64).sumCommon(0, matrix, 0, values));
    assertEquals(8, Arrays.stream(counts).sum());
    assertEquals(2, counts[129]);
  }

  @Test
  void reshapedMatrixHoldsRowsOfItsNewLength() {
    BitMatrix matrix = new BitMatrix(3, 200);
    matrix.reshape(70);
    assertEquals(2, matrix.words());
    for (int row = 0; row < 3; row++) {
      matrix.clear(row);
    }
    matrix.set(1, 69);
    assertArrayEquals(
        new boolean[] {false, true, false},
        new boolean[] {matrix.has(0, 69), matrix.has(1, 69), matrix.has(2, 69)});
  }

  private static BitSet randomSet(SplittableRandom random, int columns) {
    BitSet set = new BitSet();
    IntStream.range(0, columns).filter(column -> random.nextInt(3) > 0).forEach(set::set);
    return set;
  }
}
