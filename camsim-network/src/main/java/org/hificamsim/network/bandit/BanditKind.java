package org.hificamsim.network.bandit;

import java.util.List;
import java.util.Random;
import org.hificamsim.network.agent.Named;

/** The bandits of CamSim (behaviour 9.3). */
public enum BanditKind implements Named {
  EPSILON_GREEDY("EpsilonGreedy") {
    @Override
    public BanditSolver solver(BanditParameters parameters, Random random) {
      ArmChoice choice = new EpsilonGreedy(parameters.epsilon());
      return new BanditSolver(choice, parameters.withoutShares(), random);
    }
  },
  UCB1("UCB1") {
    @Override
    public BanditSolver solver(BanditParameters parameters, Random random) {
      return new BanditSolver(new Ucb1(), parameters.withoutShares(), random);
    }
  },
  UCB2("UCB2") {
    @Override
    public BanditSolver solver(BanditParameters parameters, Random random) {
      return new BanditSolver(new Ucb2(parameters.epsilon()), parameters, random);
    }
  },
  UCB_TUNED("UCBTuned") {
    @Override
    public BanditSolver solver(BanditParameters parameters, Random random) {
      return new BanditSolver(new UcbTuned(), parameters, random);
    }
  },
  SOFT_MAX("SoftMax") {
    @Override
    public BanditSolver solver(BanditParameters parameters, Random random) {
      return new BanditSolver(new SoftMax(parameters.epsilon()), parameters, random);
    }
  },
  FULL_RANDOM("FullRandom") {
    @Override
    public BanditSolver solver(BanditParameters parameters, Random random) {
      return new BanditSolver(new FullRandom(), parameters, random);
    }
  };

  private final String shortName;

  BanditKind(String shortName) {
    this.shortName = shortName;
  }

  @Override
  public String shortName() {
    return shortName;
  }

  @Override
  public List<String> classNames() {
    return List.of("epics.bandits." + shortName, "epics.learning." + shortName);
  }

  /** A new solver; draws one number an arm. */
  public abstract BanditSolver solver(BanditParameters parameters, Random random);
}
