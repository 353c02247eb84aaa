package org.hificamsim.acceptance;

import static java.util.stream.Collectors.joining;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import java.io.IOException;
import java.lang.reflect.Field;
import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.output.Column;
import org.hificamsim.runs.output.Table;

/** {@code docs/data.md} has the columns of every table and all metrics, as they are declared. */
@AnalyzeClasses(packages = "org.hificamsim", importOptions = ImportOption.DoNotIncludeTests.class)
class DataDocumentTest {
  @ArchTest
  static void theDocumentHasWhatIsDeclared(JavaClasses classes) throws IOException {
    Map<String, Table<?>> tables = new TreeMap<>();
    classes.stream()
        .flatMap(type -> type.getFields().stream())
        .filter(field -> field.getRawType().isEquivalentTo(Table.class))
        .filter(field -> field.getModifiers().contains(JavaModifier.STATIC))
        .map(DataDocumentTest::table)
        .forEach(table -> tables.merge(table.file(), table, DataDocumentTest::wider));
    Map<String, String> parts = new TreeMap<>();
    tables.forEach((file, table) -> parts.put(file, columns(table)));
    parts.put("metrics", metrics());
    GeneratedParts.check("docs/data.md", parts);
  }

  private static Table<?> table(JavaField constant) {
    try {
      Field field = constant.reflect();
      field.setAccessible(true);
      return (Table<?>) field.get(null);
    } catch (IllegalAccessException e) {
      throw new IllegalStateException(e);
    }
  }

  private static Table<?> wider(Table<?> one, Table<?> other) {
    return one.columns().size() < other.columns().size() ? other : one;
  }

  private static String columns(Table<?> table) {
    return "| column | unit | meaning |\n|---|---|---|\n"
        + table.columns().stream()
            .map(column -> row(column.name(), column.unit(), meaning(column)))
            .collect(joining());
  }

  private static String meaning(Column<?> column) {
    return column.meaning() + (column.isLater() ? "; missing in folders of version 0.1.0" : "");
  }

  private static String metrics() {
    return "| metric | unit | meaning |\n|---|---|---|\n"
        + Arrays.stream(Metric.values())
            .map(metric -> row(metric.label(), metric.unit(), metric.meaning()))
            .collect(joining());
  }

  private static String row(String name, String unit, String meaning) {
    return "| `" + name + "` | " + unit + " | " + meaning + " |\n";
  }
}
