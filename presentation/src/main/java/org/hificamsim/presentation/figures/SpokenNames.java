package org.hificamsim.presentation.figures;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The names of policies and detections as people read them, in pictures and on pages. */
public final class SpokenNames {
  private static final JsonFactory JSON = new JsonFactory();
  private static final int LONGEST = 300;
  private static final Pattern TIED = Pattern.compile(" \\| ");
  private static final Pattern NAME = Pattern.compile("[\\w./-]+([:@]\\S+)?");
  private static final Pattern RULE = Pattern.compile("(.*?)(?:@([a-z0-9.].*))?");
  private static final Pattern FITTED = Pattern.compile("([^-]+)-(.*?)(-gt)?");
  private static final Map<String, String> RULES =
      Map.of("chance", "by chance", "probability", "by probability", "threshold", "by threshold");
  private static final Map<String, String> MODELS =
      Map.of(
          "camsim-range", "CamSim range",
          "camsim-standard", "CamSim standard",
          "camsim-visibility", "CamSim visibility",
          "dori-2014", "EN 62676-4:2014",
          "oodpcvs-2025", "IEC 62676-4:2025",
          "ttpf", "TTPF");
  private static final Map<String, String> LAWS =
      Map.of(
          "lin", "linear",
          "sr", "symbolic",
          "svr-lin", "linear support vectors",
          "svr-rbf", "RBF support vectors",
          "power", "power law",
          "pinhole", "pinhole law");

  private SpokenNames() {}

  /** The names in the data of a page that people read in other words, as a JSON object. */
  public static String json(String json) {
    Map<String, String> spoken = new TreeMap<>();
    try (JsonParser parser = JSON.createParser(json)) {
      while (parser.nextToken() != null) {
        if (parser.currentToken() == JsonToken.VALUE_STRING && parser.getTextLength() < LONGEST) {
          TIED.splitAsStream(parser.getText())
              .filter(NAME.asMatchPredicate())
              .filter(name -> !of(name).equals(name))
              .forEach(name -> spoken.put(name, of(name)));
        }
      }
      return new ObjectMapper().writeValueAsString(spoken);
    } catch (IOException e) {
      throw new UncheckedIOException("the data of a page is not JSON", e);
    }
  }

  /** The name of a policy or detection, such as {@code hifi:orb-lin@chance}, in words. */
  public static String of(String spec) {
    Matcher parts = RULE.matcher(spec);
    if (!parts.matches()) {
      return spec;
    }
    String[] name = parts.group(1).split(":", 2);
    String options = name.length > 1 ? name[1] : "";
    List<String> words = new ArrayList<>();
    if (name[0].equals("hifi") || name[0].equals("lab")) {
      words.add(fitted(name[0], options));
    } else {
      words.add(MODELS.getOrDefault(name[0], name[0]));
      words.addAll(Arrays.asList(options.split(",")));
    }
    if (parts.group(2) != null) {
      Arrays.stream(parts.group(2).split("[:,]"))
          .forEach(rule -> words.add(RULES.getOrDefault(rule, rule)));
    }
    words.removeIf(String::isEmpty);
    return String.join(", ", words).replace("=", " ");
  }

  private static String fitted(String family, String model) {
    Matcher parts = FITTED.matcher(model);
    String origin = family.equals("lab") ? ", from the laboratory" : "";
    if (!parts.matches()) {
      return model.toUpperCase(Locale.ROOT) + origin;
    }
    String law = LAWS.getOrDefault(parts.group(2), parts.group(2));
    String chapter = parts.group(3) == null ? "" : ", chapter 5";
    return parts.group(1).toUpperCase(Locale.ROOT) + " " + law + chapter + origin;
  }
}
