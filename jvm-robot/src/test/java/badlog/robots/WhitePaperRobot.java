package badlog.robots;

import badlog.lib.BadLog;
import badlog.lib.DataInferMode;

/** The example of the white paper, with known numbers. */
public final class WhitePaperRobot {
    private BadLog log;
    private double matchTime = 15.0;

    public void robotInit(String path) {
        log = BadLog.init(path);
        BadLog.createValue("Match_Number", "" + 8);
        BadLog.createTopic("Match_Time", "s", () -> matchTime);
        BadLog.createTopicSubscriber("Random_Numbers", BadLog.UNITLESS, DataInferMode.DEFAULT, "integrate");
        log.finishInitialization();
    }

    public void periodic(double random) {
        BadLog.publish("Random_Numbers", random);
        log.updateTopics();
        log.log();
        matchTime -= 0.02;
    }
}
