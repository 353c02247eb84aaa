package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.hificamsim.presentation.report.Report;
import org.hificamsim.runs.output.ResultFolder;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code hificamsim report}: a run or a comparison as one HTML file. */
@Command(
    name = "report",
    description = {
      "Makes one HTML file, for any browser, of what run --record or compare wrote.",
      "Asked for pictures of a run, it makes those; and the page too, if --out says where."
    })
final class ReportCommand implements Callable<Integer> {
  @Parameters(paramLabel = "DIR", description = "The folder that the command wrote.")
  private Path folder;

  @Option(
      names = "--out",
      paramLabel = "FILE.html",
      description = "The page; default: DIR/" + ResultFolder.REPORT + ".")
  private Path out;

  @Mixin private PictureOptions pictures;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() throws IOException {
    pictures.check(spec.commandLine().getParseResult());
    if (pictures.asked()) {
      pictures.write(folder, spec.commandLine().getOut());
      if (out == null) {
        return 0;
      }
    }
    Path page = out != null ? out : folder.resolve(ResultFolder.REPORT);
    Report.write(folder, page);
    spec.commandLine().getOut().println(page);
    return 0;
  }
}
