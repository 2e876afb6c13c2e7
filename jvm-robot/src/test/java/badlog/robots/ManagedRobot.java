package badlog.robots;

import badlog.lib.BadLog;
import badlog.lib.RobotLog;
import badlog.lib.RobotLogOptions;
import java.io.File;

/**
 * A robot program that runs in its own process, as in a match. It logs into the folder in the first argument, gzipped if the second is
 * {@code true}, learns its match while it logs, and ends once the log has the match's name. Its loop never pauses, so rows are written
 * during the renaming.
 */
public final class ManagedRobot {
    private static final int ROWS_BEFORE = 50;
    private static final int ROWS_AFTER = 50;

    private static volatile String match = "";
    private static long row;

    private ManagedRobot() {
    }

    public static void main(String[] args) {
        RobotLogOptions options = new RobotLogOptions();
        options.setFolder(new File(args[0]));
        options.setCompressed(Boolean.parseBoolean(args[1]));
        options.setEnabled(() -> true);
        options.setClockSet(() -> true);
        options.setEvent(() -> match.isEmpty() ? "" : "OHCL");
        options.setMatch(() -> match);
        options.setBatteryVoltage(null);
        try (RobotLog log = RobotLog.start(options)) {
            BadLog.createTopicLong("Row", BadLog.UNITLESS, () -> row++);
            loopUntilNamed(log);
            for (int i = 0; i < ROWS_AFTER; i++) {
                log.periodic();
            }
        }
    }

    private static void loopUntilNamed(RobotLog log) {
        while (!isNamed(log)) {
            log.periodic();
            if (row > ROWS_BEFORE) {
                match = "Q42";
            }
        }
    }

    private static boolean isNamed(RobotLog log) {
        return log.getFile() != null && log.getFile().getName().contains("_OHCL_Q42");
    }
}
