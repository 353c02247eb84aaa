package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.FileRecord;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.presentation.report.Report;
import org.hificamsim.presentation.report.TradeoffReport;
import org.hificamsim.runs.output.ResultFolder;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code hificamsim report}: makes a page, or pictures, of a run or a comparison. */
@Command(
    name = "report",
    description = {
      "Makes one HTML page from the folder of run --record, compare, ladder or tradeoff.",
      "With options for pictures it makes these, and the page only if --out is given."
    })
final class ReportCommand implements Callable<Integer> {
  @Parameters(paramLabel = "DIR", description = "The folder of results.")
  private Path folder;

  @Option(
      names = "--out",
      paramLabel = "FILE.html",
      description = "The page; default: DIR/" + ResultFolder.REPORT + ".")
  private Path out;

  @Option(names = "--replays")
  private boolean replays;

  @Mixin private Destination destination;

  @Mixin private PictureOptions pictures;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() throws IOException {
    pictures.check(spec.commandLine().getParseResult());
    pictures.claim(destination);
    OutputFile page = out == null ? null : destination.file("--out", out);
    OutputFolder.settle(folder);
    List<String> changed = FileRecord.of(folder).changed(folder);
    if (pictures.isAsked()) {
      pictures.write(folder, destination, spec.commandLine().getOut());
    }
    if (replays) {
      for (List<String> words : TradeoffReport.replays(folder, Flags.NOTATION)) {
        CommandLine line = spec.commandLine();
        Main.execute(line.getOut(), line.getErr(), words.toArray(String[]::new));
      }
    }
    if (page != null) {
      page.write(html());
      spec.commandLine().getOut().println(out);
    } else if (!pictures.isAsked()) {
      writeIntoFolder();
    }
    if (!changed.isEmpty()) {
      spec.commandLine()
          .getErr()
          .printf(
              "warning: '%s': not as it was written: %s (%s)%n",
              folder, Place.printable(String.join(", ", changed)), FileRecord.NAME);
    }
    return 0;
  }

  private String html() throws IOException {
    return Report.html(folder, ResultFolder.name(folder), Flags.NOTATION);
  }

  private void writeIntoFolder() throws IOException {
    String html = html();
    try (OutputFolder results = new OutputFolder(folder)) {
      results.write(ResultFolder.REPORT, html);
      if (TradeoffReport.suits(folder)) {
        FigureFile.write(results, "tradeoff", TradeoffReport.figure(folder));
      }
      results.commit(List.of());
    }
    spec.commandLine().getOut().println(folder.resolve(ResultFolder.REPORT));
  }
}
