package org.hificamsim.worlds;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.InputException;

/** How the shared block of memory is divided. */
public record Block(List<Section> sections) {
  private static final int LINE = 64; // bytes of a cache line, where each section begins

  /**
   * A part of the block of memory that is shared with who trains: an array, row by row.
   *
   * @param type as NumPy writes it: i4, f4 or u1, in the machine's byte order
   * @param shape its dimensions, the worlds first
   * @param offset where it begins, in bytes
   */
  public record Section(String name, String type, List<Integer> shape, int offset) {
    /** How long it is. */
    public int bytes() {
      return size() * (type.equals("u1") ? 1 : Integer.BYTES);
    }

    /** How many numbers it has. */
    public int size() {
      return shape.stream().reduce(1, Math::multiplyExact);
    }
  }

  /** Copies what could change. */
  public Block {
    sections = List.copyOf(sections);
  }

  /**
   * The block of some worlds.
   *
   * @param of one of them
   */
  static Block of(int worlds, OneWorld of, WorldSettings settings) {
    int cameras = of.network().cameras();
    int size = settings.layout().size();
    Builder builder = new Builder(worlds);
    builder.add("actions", "i4", cameras, settings.actions().numbers());
    builder.add("observations", "f4", cameras, size);
    builder.add("finals", "f4", cameras, size);
    builder.add("rewards", "f4", cameras);
    builder.add("masks", "u1", cameras, Masks.width(of.network(), settings.actions()));
    builder.add("ends", "u1");
    builder.add("measures", "f4", OneWorld.MEASURES);
    builder.add("advice", "i4", cameras);
    builder.add("states", "f4", OneWorld.stateSize(of.network(), settings.layout()));
    return new Block(builder.sections);
  }

  /** How long it is, in bytes. */
  public int bytes() {
    Section last = sections.get(sections.size() - 1);
    return last.offset() + last.bytes();
  }

  /** A section of a block, in the machine's byte order. */
  ByteBuffer part(ByteBuffer block, String name) {
    Section section =
        sections.stream().filter(one -> one.name().equals(name)).findFirst().orElseThrow();
    return block.slice(section.offset(), section.bytes()).order(ByteOrder.nativeOrder());
  }

  private static final class Builder {
    private final int worlds;
    private final List<Section> sections = new ArrayList<>();
    private int end;

    Builder(int worlds) {
      this.worlds = worlds;
    }

    void add(String name, String type, int... each) {
      List<Integer> shape = new ArrayList<>();
      shape.add(worlds);
      for (int length : each) {
        shape.add(length);
      }
      try {
        Section section = new Section(name, type, shape, end);
        end = Math.multiplyExact(Math.addExact(end, section.bytes() + LINE - 1) / LINE, LINE);
        sections.add(section);
      } catch (ArithmeticException e) {
        throw new InputException(
            worlds + " worlds take more than 2 GB of shared memory, expected fewer", e);
      }
    }
  }
}
