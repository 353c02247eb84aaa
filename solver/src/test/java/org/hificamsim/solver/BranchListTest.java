package org.hificamsim.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class BranchListTest {
  private static final int DEPTH = 3;
  private static final int WIDTH = 3;

  /** Writes down the words of three letters a, b and c, those that end in c first. */
  private static final class Words implements BranchList.Problem {
    private final BranchList branches = new BranchList(this, DEPTH);
    private final List<String> found = new ArrayList<>();
    private String word = "";
    private String last = "";
    private char greatest = 'c';

    private boolean search(long maxNodes) {
      branches.begin();
      return new BranchAndBound().search(branches, maxNodes);
    }

    @Override
    public void list(int depth) {
      assertEquals(word.length(), depth);
      if (depth == DEPTH) {
        found.add(word);
        assertEquals(word.charAt(1), (char) branches.taken(1));
      }
      for (char letter = 'a'; depth < DEPTH && letter < 'a' + WIDTH; letter++) {
        branches.add(letter, letter == 'c' ? 1 : 0);
      }
    }

    @Override
    public boolean isPromising(int depth, int branch) {
      assertEquals(branch == 'c' ? 1 : 0, branches.value(depth));
      return branch <= greatest;
    }

    @Override
    public void take(int depth, int branch) {
      word += (char) branch;
    }

    @Override
    public void undo(int depth, int branch) {
      assertEquals(branch, word.charAt(depth));
      word = word.substring(0, depth);
    }

    @Override
    public boolean isDone() {
      return !last.isEmpty() && found.contains(last);
    }
  }

  @Test
  void visitsEveryLeafBranchesOfGreaterValueFirst() {
    Words words = new Words();
    assertTrue(words.search(Long.MAX_VALUE));
    assertEquals(27, words.found.size());
    assertEquals(List.of("ccc", "cca", "ccb", "cac"), words.found.subList(0, 4));
    assertEquals("bbb", words.found.get(26));
    assertEquals("", words.word);
  }

  @Test
  void sortsNodesOfAnyNumberOfBranches() {
    List<Integer> taken = new ArrayList<>();
    BranchList[] branches = new BranchList[1];
    branches[0] =
        new BranchList(
            new BranchList.Problem() {
              @Override
              public void list(int depth) {
                for (int branch = 0; depth == 0 && branch < 100; branch++) {
                  branches[0].add(branch, branch * 37 % 100);
                }
              }

              @Override
              public void take(int depth, int branch) {
                assertEquals(branch * 37 % 100, branches[0].value(0));
                taken.add(branch * 37 % 100);
              }

              @Override
              public void undo(int depth, int branch) {}
            },
            1);
    branches[0].begin();
    assertTrue(new BranchAndBound().search(branches[0], Long.MAX_VALUE));
    assertEquals(IntStream.range(0, 100).map(i -> 99 - i).boxed().toList(), taken);
  }

  @Test
  void leavesNodeWhoseNextBranchIsNotPromising() {
    Words words = new Words();
    words.greatest = 'b'; // c comes first
    assertTrue(words.search(Long.MAX_VALUE));
    assertEquals(List.of(), words.found);
  }

  @Test
  void endsWhenProblemIsDone() {
    Words words = new Words();
    words.last = "cca";
    assertTrue(words.search(Long.MAX_VALUE));
    assertEquals(List.of("ccc", "cca"), words.found);
  }

  @Test
  void givesUpAfterNodesAndBeginsAnew() {
    Words words = new Words();
    assertFalse(words.search(4));
    assertEquals(List.of("ccc", "cca"), words.found);
    words.word = "";
    words.found.clear();
    assertTrue(words.search(39));
    assertEquals(27, words.found.size());
  }
}
