package org.hificamsim.solver;

import java.util.Arrays;
import java.util.BitSet;

/**
 * A matrix of bits. Each row is a set of columns, such as the targets that a camera detects: column
 * c is bit {@code c % 64} of word {@code c / 64} of the row.
 *
 * <p>Fast loops combine rows word by word, and go over the columns of a word like this:
 *
 * <pre>{@code
 * for (long bits = matrix.word(row, word); bits != 0; bits &= bits - 1) {
 *   int column = BitMatrix.firstColumn(word, bits);
 * }
 * }</pre>
 */
public final class BitMatrix {
  private static final int WORD_SHIFT = 6;

  private final int rows;
  private final long[] bits;
  private int words;

  /** Creates a matrix without bits. */
  public BitMatrix(int rows, int columns) {
    this.rows = rows;
    words = wordsFor(columns);
    bits = new long[Math.multiplyExact(rows, words)];
  }

  /** The number of words that a row of some columns takes. */
  public static int wordsFor(int columns) {
    return (columns + Long.SIZE - 1) / Long.SIZE;
  }

  /** The first column whose bit is set in one word of a row; the word is not 0. */
  public static int firstColumn(int word, long bits) {
    return (word << WORD_SHIFT) + Long.numberOfTrailingZeros(bits);
  }

  /** Adds {@code change} to the count of each column in one word of a row. */
  public static void add(int[] counts, int word, long bits, int change) {
    for (long rest = bits; rest != 0; rest &= rest - 1) {
      counts[firstColumn(word, rest)] += change;
    }
  }

  /**
   * Changes the number of columns, for at most as many as at first; the rows have to be set again.
   */
  public void reshape(int columns) {
    words = wordsFor(columns);
  }

  /** Returns the same rows with space for more columns. */
  public BitMatrix widened(int columns) {
    BitMatrix wider = new BitMatrix(rows, columns);
    for (int row = 0; row < rows; row++) {
      System.arraycopy(bits, row * words, wider.bits, row * wider.words, words);
    }
    return wider;
  }

  /** Returns a matrix of one row, with the first columns of a row. */
  public BitMatrix row(int row, int columns) {
    BitMatrix single = new BitMatrix(1, columns);
    single.setRow(0, bits, row * words);
    return single;
  }

  /** The number of rows. */
  public int rows() {
    return rows;
  }

  /** The number of words of a row. */
  public int words() {
    return words;
  }

  /** One word of a row. */
  public long word(int row, int word) {
    return bits[row * words + word];
  }

  /** Replaces one word of a row. */
  public void setWord(int row, int word, long newBits) {
    bits[row * words + word] = newBits;
  }

  /** Replaces a row by the words of {@code source} from {@code from} on. */
  public void setRow(int row, long[] source, int from) {
    for (int word = 0; word < words; word++) {
      bits[row * words + word] = source[from + word];
    }
  }

  /** Removes all columns of a row. */
  public void clear(int row) {
    Arrays.fill(bits, row * words, (row + 1) * words, 0);
  }

  /** Replaces a row by one of another matrix. */
  public void setRow(int row, BitMatrix other, int otherRow) {
    setRow(row, other.bits, otherRow * other.words);
  }

  /** Adds a column to a row. */
  public void set(int row, int column) {
    bits[row * words + (column >> WORD_SHIFT)] |= 1L << column;
  }

  /** Whether a row has a column. */
  public boolean has(int row, int column) {
    return (bits[row * words + (column >> WORD_SHIFT)] >>> column & 1) != 0;
  }

  /** The number of columns of a row. */
  public int count(int row) {
    return countCommon(row, this, row);
  }

  /** The number of columns that a row and one of another matrix have in common. */
  public int countCommon(int row, BitMatrix other, int otherRow) {
    int count = 0;
    for (int word = 0; word < words; word++) {
      count += Long.bitCount(word(row, word) & other.word(otherRow, word));
    }
    return count;
  }

  /** Adds {@code change} to the count of each column of a row. */
  public void add(int row, int[] counts, int change) {
    for (int word = 0; word < words; word++) {
      add(counts, word, word(row, word), change);
    }
  }

  /** The sum of the values of a row's columns. */
  public long sum(int row, long[] values) {
    return sumCommon(row, this, row, values);
  }

  /** The sum of the values of the columns that a row and one of another matrix have in common. */
  public long sumCommon(int row, BitMatrix other, int otherRow, long[] values) {
    long sum = 0;
    for (int word = 0; word < words; word++) {
      long common = word(row, word) & other.word(otherRow, word);
      for (; common != 0; common &= common - 1) {
        sum += values[firstColumn(word, common)];
      }
    }
    return sum;
  }

  /** Adds the columns of a row of another matrix to a row. */
  public void unite(int row, BitMatrix other, int otherRow) {
    for (int word = 0; word < words; word++) {
      bits[row * words + word] |= other.word(otherRow, word);
    }
  }

  /**
   * Leaves a row the columns that it has in common with a row of another matrix, which has at least
   * as many columns.
   *
   * @return whether any are left
   */
  public boolean intersect(int row, BitMatrix other, int otherRow) {
    long left = 0;
    for (int word = 0; word < words; word++) {
      bits[row * words + word] &= other.word(otherRow, word);
      left |= bits[row * words + word];
    }
    return left != 0;
  }

  /** Removes the columns of a row of another matrix from a row. */
  public void subtract(int row, BitMatrix other, int otherRow) {
    for (int word = 0; word < words; word++) {
      bits[row * words + word] &= ~other.word(otherRow, word);
    }
  }

  /** The columns of a row, in ascending order. */
  public int[] columns(int row) {
    return BitSet.valueOf(Arrays.copyOfRange(bits, row * words, (row + 1) * words)).stream()
        .toArray();
  }

  /** Whether a row has all columns of another one. */
  public boolean includes(int row, int other) {
    return includes(row, bits, other * words);
  }

  /** Whether a row has all columns in the words of {@code source} from {@code from} on. */
  public boolean includes(int row, long[] source, int from) {
    long missing = 0;
    for (int word = 0; word < words; word++) {
      missing |= source[from + word] & ~bits[row * words + word];
    }
    return missing == 0;
  }
}
