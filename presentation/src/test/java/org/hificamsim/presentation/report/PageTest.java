package org.hificamsim.presentation.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.Base64;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PageTest {
  private static final String HOSTILE = "</script><!--<script><img src=x onerror=alert(1)>";

  private final String html =
      new Page(HOSTILE, "run-page.js", "runPage", "{\"name\":\"" + HOSTILE + "\"}").html();

  @Test
  void textsCannotEndElements() {
    assertFalse(html.contains("<img"));
    assertTrue(html.contains("<title>&lt;/script&gt;"));
    assertTrue(html.contains("\\u003c/script>"));
    assertEquals(3, html.split("</script>", -1).length - 1, "the data, uPlot and the page's own");
  }

  @Test
  void pageAllowsItsOwnScriptsOnly() throws Exception {
    String policy =
        html.replaceFirst("(?s).*Content-Security-Policy\" content=\"([^\"]*)\".*", "$1");
    assertTrue(policy.startsWith("default-src 'none';"), policy);
    assertFalse(policy.contains("unsafe"), policy);
    Matcher scripts =
        Pattern.compile("(?s)<script(?: type=\"module\")?>(.*?)</script>").matcher(html);
    int count = 0;
    while (scripts.find()) {
      byte[] digest =
          MessageDigest.getInstance("SHA-256")
              .digest(scripts.group(1).getBytes(StandardCharsets.UTF_8));
      assertTrue(policy.contains("sha256-" + Base64.getEncoder().encodeToString(digest)));
      count++;
    }
    assertEquals(2, count);
  }

  @Test
  void pageHasLicenceOfUplot() {
    assertTrue(html.contains("The MIT License (MIT)") && html.contains("Leon Sorokin"));
  }

  @ParameterizedTest
  @CsvSource({"run-page.js", "comparison-page.js"})
  void bundleHasEachModuleOnceAfterItsImports(String entry) {
    String bundle = Scripts.bundle(entry);
    assertFalse(Pattern.compile("(?m)^(import|export) ").matcher(bundle).find(), "left over");
    assertEquals(1, bundle.split("const module_dom = ", -1).length - 1);
    int entryStart = bundle.indexOf("const " + Scripts.variable(entry) + " = ");
    assertTrue(bundle.indexOf("const module_dom = ") < entryStart);
  }
}
