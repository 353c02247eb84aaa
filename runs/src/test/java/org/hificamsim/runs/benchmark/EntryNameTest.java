package org.hificamsim.runs.benchmark;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class EntryNameTest {
  @ParameterizedTest
  @ValueSource(
      strings = {
        "Cooperative",
        "co-0perative",
        "COOPERATIVE",
        "c\u03bfoperative",
        "coo\u0301perative",
        "\uff43ooperative",
        "coope rative",
        "cooperat\u0131ve",
        "cooperat1ve"
      })
  void namesThatLookAlikeHaveTheSameSkeleton(String name) {
    EntryName.require(name);
    assertEquals(EntryName.skeleton("cooperative"), EntryName.skeleton(name.replace("-", "")));
  }

  @Test
  void cyrillicNameHasSkeletonOfLatinLookalike() {
    EntryName.require("\u0441\u043e\u0440\u0435");
    assertEquals(EntryName.skeleton("cope"), EntryName.skeleton("\u0441\u043e\u0440\u0435"));
  }

  @Test
  void dashesLookAlike() {
    assertEquals(EntryName.skeleton("co-op"), EntryName.skeleton("co\u2010op"));
    assertEquals(EntryName.skeleton("co-op"), EntryName.skeleton("co\u2014op"));
  }

  @Test
  void differentNamesHaveDifferentSkeletons() {
    assertNotEquals(EntryName.skeleton("QMIX"), EntryName.skeleton("VDN"));
    assertNotEquals(EntryName.skeleton("\u5354\u529b"), EntryName.skeleton("\u5354\u540c"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"QMIX-\u03bb", "\u5354\u529b by us", "\u041c\u044b 2", "<stay>"})
  void acceptsNamesOfManyLanguages(String name) {
    EntryName.require(name);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        " ",
        "a\nb",
        "a\u202eb",
        "a\u200bb",
        "a\u3164b",
        "co\u043eperative",
        "h\u1d0fnest"
      })
  void rejectsNamesThatDeceive(String name) {
    assertThrows(InputException.class, () -> EntryName.require(name));
  }
}
