package badlog.robots;

import badlog.lib.BadLog;

/** The lines of the README, in a program in which they run. */
public final class ReadmeRobot {
    private ReadmeRobot() {
    }

    private static final class Arm {
        double getAngle() {
            return 12.346;
        }
    }

    public static void run(String file) {
        Arm arm = new Arm();
        BadLog log = BadLog.init(file);
        BadLog.createTopicDouble("Arm/Angle", "deg", arm::getAngle, "differentiate");
        log.finishInitialization();
        log.updateTopics();
        log.log();
        log.close();
    }
}
