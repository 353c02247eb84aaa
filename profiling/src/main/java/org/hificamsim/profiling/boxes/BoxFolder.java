package org.hificamsim.profiling.boxes;

import java.io.IOException;
import java.util.Optional;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.FileRecord;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.hifi.boxes.BoxDetection;
import org.hificamsim.hifi.model.ModelFiles;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.profiling.dataset.TableLayout;

/** Writes the measured boxes: a row for each, the table of shares, a picture, and the model. */
public final class BoxFolder {
  /** The table of boxes. */
  public static final String BOXES = "boxes.csv";

  /** The table of shares. */
  public static final String FOUND = "found.csv";

  /** The picture, without its ending. */
  public static final String PICTURE = "found";

  private BoxFolder() {}

  /** Returns the file of a model in the folder. */
  public static String modelFile(String name) {
    return "models/" + name.replaceAll("[^A-Za-z0-9._-]", "-") + ".json";
  }

  /**
   * Writes the files, all or none.
   *
   * @param shown the model that the picture and the table show next to the measured shares
   * @param fitted the model to write, if one was fitted
   */
  public static void write(
      OutputFolder folder,
      MeasuredBoxes measured,
      Optional<BoxDetection> shown,
      Optional<BoxDetection> fitted)
      throws IOException {
    folder.write(BOXES, layout(shown).csv(measured.boxes()));
    folder.write(FOUND, new FoundTable(measured).csv());
    FigureFile.write(
        folder, PICTURE, new BoxFigure(measured, shown.map(BoxDetection::curve)).figure());
    if (fitted.isPresent()) {
      folder.write(modelFile(fitted.get().name()), ModelFiles.bytes(fitted.get()));
    }
    folder.commit(
        FileRecord.of(folder.path()).names().stream().filter(BoxFolder::isModel).toList());
  }

  private static boolean isModel(String name) {
    return name.startsWith("models/");
  }

  private static TableLayout<PersonBox> layout(Optional<BoxDetection> model) {
    TableLayout<PersonBox> layout =
        new TableLayout<PersonBox>()
            .with("recording", box -> TableLayout.quoted(box.recording()))
            .with("frame", PersonBox::frame)
            .with("person", box -> TableLayout.quoted(personOf(box)))
            .with("height_px", box -> rounded(2, box.height()))
            .with("width_px", box -> rounded(2, box.box().width()))
            .with("hidden_by_people", box -> rounded(4, box.parts().byPeople()))
            .with("cut_by_border", box -> rounded(4, box.parts().byBorder()))
            .with("hidden", box -> rounded(4, box.hidden()))
            .with("found", PersonBox::found);
    model.ifPresent(
        detection -> layout.with("chance", box -> rounded(6, box.chance(detection.curve()))));
    return layout;
  }

  private static String personOf(PersonBox box) {
    return box.person().substring(box.recording().length() + 1);
  }

  private static String rounded(int digits, double value) {
    return Texts.format("%." + digits + "f", value);
  }
}
