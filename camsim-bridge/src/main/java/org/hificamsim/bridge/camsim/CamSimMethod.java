package org.hificamsim.bridge.camsim;

import java.util.List;
import java.util.stream.Collectors;

/**
 * An instance method of CamSim's that the bridge calls or changes.
 *
 * @param type the class's full name
 * @param parameters full names of the parameters' types
 * @param woven whether the class itself has to declare it, since a hook goes into it
 */
record CamSimMethod(
    String type, String name, List<String> parameters, Returned returned, boolean woven) {
  @Override
  public String toString() {
    return type + "." + name + signature() + returned.words();
  }

  private String signature() {
    return parameters.stream()
        .map(parameter -> parameter.substring(parameter.lastIndexOf('.') + 1))
        .collect(Collectors.joining(", ", "(", ")"));
  }

  /** What a method gives back. */
  enum Returned {
    ANYTHING,
    SOMETHING,
    NUMBER,
    FLAG;

    boolean test(String type) {
      return switch (this) {
        case ANYTHING -> true;
        case SOMETHING -> !type.equals("void");
        case NUMBER -> type.equals("double");
        case FLAG -> type.equals("boolean");
      };
    }

    String words() {
      return switch (this) {
        case ANYTHING, SOMETHING -> "";
        case NUMBER -> " returning double";
        case FLAG -> " returning boolean";
      };
    }
  }
}
