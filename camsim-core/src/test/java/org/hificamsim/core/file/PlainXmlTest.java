package org.hificamsim.core.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.GZIPOutputStream;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.xml.sax.Attributes;

class PlainXmlTest {
  @TempDir Path folder;

  private static final class Points extends PlainXml {
    private final List<String> found = new ArrayList<>();

    @Override
    public void startElement(String uri, String localName, String name, Attributes attributes) {
      if (name.equals("p")) {
        found.add(text(attributes, name, "id") + " " + number(attributes, name, "x"));
      }
    }
  }

  @Test
  void readsCompressedFiles() throws IOException {
    String text = "<a><p id='one' x='1e9'/>\n<p id='' x='-1E9'/></a>";
    Path plain = Files.writeString(folder.resolve("a.xml"), text);
    Path packed = folder.resolve("a.xml.gz");
    try (OutputStream out = new GZIPOutputStream(Files.newOutputStream(packed))) {
      out.write(text.getBytes(StandardCharsets.UTF_8));
    }
    for (Path file : List.of(plain, packed)) {
      Points points = new Points();
      points.readFile(file);
      assertEquals(List.of("one 1.0E9", " -1.0E9"), points.found);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      value = {
        "<a>; <p x='1'/> | 2:12: <p> has no id, expected one",
        "<a><p id='' x='1000000001'/> | 1:29: <p> x is '1000000001',"
            + " expected a number from -1e9 to 1e9",
        "<a><p id='' x='NaN'/> | 1:22: <p> x is 'NaN', expected a number from -1e9 to 1e9",
        "<a>;;<b> | 3:4: not well-formed XML, or cut off, expected a whole file:"
            + " XML document structures must start and end within the same entity.",
        "\"\" | 1:1: not well-formed XML, or cut off, expected a whole file:"
            + " Premature end of file.",
      })
  void errorsNameTheirPlace(String text, String expected) throws IOException {
    Path file = Files.writeString(folder.resolve("a.xml"), text.replace(';', '\n'));
    InputException e = assertThrows(InputException.class, () -> new Points().readFile(file));
    assertEquals(file + ":" + expected, e.getMessage());
  }

  @Test
  void readsNoExternalEntities() throws IOException {
    Path secret = Files.writeString(folder.resolve("secret"), "secret");
    Path file = folder.resolve("a.xml");
    for (String head :
        List.of("<!DOCTYPE a>", "<!DOCTYPE a [<!ENTITY s SYSTEM '" + secret + "'>]>")) {
      Files.writeString(file, head + "<a>&s;</a>");
      InputException e = assertThrows(InputException.class, () -> new Points().readFile(file));
      assertEquals(true, e.getMessage().contains("DOCTYPE is disallowed"), e.getMessage());
    }
  }
}
