package org.hificamsim.presentation.report;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.file.Io;
import org.hificamsim.presentation.plot.Palette;

/**
 * Bundles the modules of a page into one script, so that a page needs no other file. Each module is
 * a function, after the modules that it imports. Supports what the modules here use: imports of
 * names, and exports where a name is declared.
 */
public final class Scripts {
  private static final Pattern IMPORT =
      Pattern.compile("(?m)^import (\\{[^}]*\\}) from '\\./([\\w-]+\\.js)';$");
  private static final Pattern EXPORT =
      Pattern.compile("(?m)^export ((?:async )?(?:function|class|const) (\\w+))");

  private final Map<String, String> modules = new LinkedHashMap<>();

  private Scripts() {}

  /** Returns a module and all modules that it needs. */
  public static String bundle(String entry) {
    Scripts scripts = new Scripts();
    scripts.add(entry);
    return "'use strict';\n" + Palette.script() + String.join("", scripts.modules.values());
  }

  /** The variable of a bundle that has a module's exports. */
  public static String variable(String module) {
    return "module_" + module.replace(".js", "").replace('-', '_');
  }

  /** JSON that no HTML parser takes for the end of the script that it is in. */
  static String escaped(String json) {
    return json.replace("<", "\\u003c");
  }

  /** Reads a file of this folder, such as a style sheet. */
  public static String text(String name) {
    return new String(Io.resource(Scripts.class, name), StandardCharsets.UTF_8);
  }

  private void add(String name) {
    if (modules.containsKey(name)) {
      return;
    }
    String source = text(name);
    Matcher imports = IMPORT.matcher(source);
    while (imports.find()) {
      add(imports.group(2));
    }
    modules.put(name, function(name, source));
  }

  private static String function(String name, String source) {
    List<String> exported = new ArrayList<>();
    Matcher exports = EXPORT.matcher(source);
    while (exports.find()) {
      exported.add(exports.group(2));
    }
    String body =
        IMPORT
            .matcher(EXPORT.matcher(source).replaceAll("$1"))
            .replaceAll(
                found -> "const " + found.group(1) + " = " + variable(found.group(2)) + ";");
    return "const %s = (() => {\n%sreturn {%s};\n})();\n"
        .formatted(variable(name), body, String.join(", ", exported));
  }
}
