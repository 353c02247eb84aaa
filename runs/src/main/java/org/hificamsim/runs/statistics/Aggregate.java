package org.hificamsim.runs.statistics;

import java.util.Locale;
import java.util.stream.DoubleStream;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.runs.Estimate;

/** One number for all runs of all scenarios; NaN where there is no run. */
public enum Aggregate {
  /** The interquartile mean: without the lowest and the highest quarter of all runs. */
  IQM {
    @Override
    public double of(Strata strata) {
      double[] sorted = strata.sorted();
      int cut = sorted.length / 4;
      return StatUtils.mean(sorted, cut, sorted.length - 2 * cut);
    }
  },
  /** How far the runs fall short of 1 on average; what is above 1 counts as 1. */
  OPTIMALITY_GAP {
    @Override
    public double of(Strata strata) {
      double[] scores = strata.sorted();
      return 1 - StatUtils.mean(DoubleStream.of(scores).map(one -> Math.min(one, 1)).toArray());
    }
  },
  /** The mean of the scenarios' means. */
  MEAN {
    @Override
    public double of(Strata strata) {
      return StatUtils.mean(strata.means());
    }
  },
  /** The median of the scenarios' means. */
  MEDIAN {
    @Override
    public double of(Strata strata) {
      return StatUtils.percentile(strata.means(), 50);
    }
  };

  /** The number. */
  public abstract double of(Strata strata);

  /** The number with its interval. */
  public Estimate estimate(Strata strata) {
    return StratifiedBootstrap.of(this::of, strata);
  }

  /** The name in files. */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }
}
