package org.hificamsim.worlds;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.InputException;

/** The layout of the shared block of memory. */
public record Block(List<Section> sections) {
  /** The bytes of a cache line; each section begins at a multiple. */
  private static final int CACHE_LINE = 64;

  /**
   * A section of the block: an array in row-major order.
   *
   * @param type the NumPy type i4, f4 or u1, in the byte order of the machine
   * @param shape the dimensions, of which the first is the number of worlds
   * @param offset the start of the section, in bytes
   */
  public record Section(String name, String type, List<Integer> shape, int offset) {
    /** The length in bytes. */
    public int bytes() {
      return size() * (type.equals("u1") ? 1 : Integer.BYTES);
    }

    /** The number of elements. */
    public int size() {
      return shape.stream().reduce(1, Math::multiplyExact);
    }
  }

  /** Copies the list. */
  public Block {
    sections = List.copyOf(sections);
  }

  /**
   * Returns the layout for a number of worlds.
   *
   * @param first one of the worlds
   */
  static Block of(int worlds, OneWorld first, WorldSettings settings) {
    int cameras = first.network().cameras();
    int size = settings.layout().size();
    Builder builder = new Builder(worlds);
    builder.add("actions", "i4", cameras, settings.actions().numbers());
    builder.add("observations", "f4", cameras, size);
    builder.add("finals", "f4", cameras, size);
    builder.add("rewards", "f4", cameras);
    int maskWidth = Masks.width(first.network(), settings.actions());
    builder.add("masks", "u1", cameras, maskWidth);
    builder.add("final_masks", "u1", cameras, maskWidth);
    builder.add("ends", "u1");
    builder.add("measures", "f4", OneWorld.MEASURES);
    builder.add("advice", "i4", cameras);
    builder.add("details", "f4", cameras, CameraDetails.COUNT);
    builder.add("states", "f4", OneWorld.stateSize(first.network(), settings.layout()));
    return new Block(builder.sections);
  }

  /** The length of the block, in bytes. */
  public int bytes() {
    Section last = sections.get(sections.size() - 1);
    return last.offset() + last.bytes();
  }

  /** Returns a section of a block, in the byte order of the machine. */
  ByteBuffer slice(ByteBuffer block, String name) {
    Section section =
        sections.stream()
            .filter(candidate -> candidate.name().equals(name))
            .findFirst()
            .orElseThrow();
    return block.slice(section.offset(), section.bytes()).order(ByteOrder.nativeOrder());
  }

  private static final class Builder {
    private final int worlds;
    private final List<Section> sections = new ArrayList<>();
    private int end;

    Builder(int worlds) {
      this.worlds = worlds;
    }

    void add(String name, String type, int... dimensionsOfWorld) {
      List<Integer> shape = new ArrayList<>();
      shape.add(worlds);
      for (int length : dimensionsOfWorld) {
        shape.add(length);
      }
      try {
        Section section = new Section(name, type, shape, end);
        end =
            Math.multiplyExact(
                Math.addExact(end, section.bytes() + CACHE_LINE - 1) / CACHE_LINE, CACHE_LINE);
        sections.add(section);
      } catch (ArithmeticException e) {
        throw new InputException(
            worlds + " worlds take more than 2 GB of shared memory, expected fewer", e);
      }
    }
  }
}
