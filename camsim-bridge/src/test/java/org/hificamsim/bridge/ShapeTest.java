package org.hificamsim.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.hificamsim.bridge.camsim.Requirements;
import org.hificamsim.bridge.camsim.Use;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class ShapeTest {
  private static final Set<Use> ALL = EnumSet.allOf(Use.class);
  private static final Set<Use> DETECTING = EnumSet.of(Use.READ, Use.DETECT);
  private static final String LOOK =
      "method CameraController.update_visiblity(TraceableObject) returning double";
  private static final String ADD =
      "method CameraController.addVisibleObject(TraceableObject, double)";
  private static final String REMOVE =
      "method CameraController.removeVisibleObject(TraceableObject)";
  private static final String CHANGE =
      "method CameraController.change(double, double, double, double, double)";

  @TempDir Path folder;

  @Test
  void doublesHaveEveryRequiredMember() throws IOException {
    assertEquals(List.of(), missing(ALL, CamSimRun.DOUBLES));
  }

  @ParameterizedTest
  @MethodSource
  void missingOrDifferentMembersAreNamed(Map<String, String> replacements, Set<String> missing)
      throws IOException {
    assertEquals(missing, Set.copyOf(missing(ALL, Variant.of(folder, replacements))));
  }

  static Stream<Arguments> missingOrDifferentMembersAreNamed() {
    return Stream.of(
        arguments(Map.of("double update_visiblity", "Double update_visiblity"), Set.of(LOOK)),
        arguments(Map.of("SimCore", "OtherCore"), Set.of("class SimCore")),
        arguments(
            Map.of("update_visiblity", "update_visibility", "TraceableObject", "Thing"),
            Set.of("class TraceableObject", LOOK, ADD, REMOVE)),
        arguments(
            Map.of(
                "addVisibleObject",
                "show",
                "removeVisibleObject",
                "hide",
                "change(",
                "alter(",
                "getHeading",
                "heading",
                "getY",
                "ordinate",
                "getFeatures",
                "features",
                "update()",
                "advance()",
                "close_files",
                "finish"),
            Set.of(
                ADD,
                REMOVE,
                CHANGE,
                "method CameraController.getHeading() returning double",
                "method CameraController.getY() returning double",
                "method TraceableObject.getY() returning double",
                "method TraceableObject.getFeatures()",
                "method SimCore.update()",
                "method SimCore.close_files()")));
  }

  @Test
  void membersThatAreNotNeededMayBeMissing() throws IOException {
    Path classes = Variant.of(folder, "change(", "alter(");
    assertEquals(List.of(), missing(DETECTING, classes));
    assertEquals(List.of(CHANGE), missing(ALL, classes));
  }

  /** Returns the names of what is missing, without the package. */
  private static List<String> missing(Set<Use> uses, Path classes) throws IOException {
    URL[] path = {classes.toUri().toURL()};
    try (URLClassLoader loader = new URLClassLoader(path, null)) {
      return Requirements.missing(uses, loader).stream()
          .map(name -> name.replace("epics.camsim.core.", ""))
          .toList();
    }
  }
}
