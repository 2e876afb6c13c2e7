package badlog.robots;

import badlog.lib.BadLog;
import badlog.lib.DataInferMode;

/**
 * Calls as teams make them. Compiled against the original, it wrote {@code recorded-script.bag}; it must write the same
 * here. It avoids the intended differences.
 */
public final class RecordedScript {
    private static final double[] NUMBERS = {
        0, -0.0, 1, -1, 12.3456789, 99999.5, 99999.4, 100000, 1e-4, 9.9999e-5, 2.00005, 1e10, -1e300, 5e-324, 0.02, 13,
        Double.MAX_VALUE, Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 0.1 + 0.2, 1.0 / 3, 12.125,
    };

    private int loop;

    private RecordedScript() {
    }

    public static void main(String[] args) {
        new RecordedScript().run(args[0]);
    }

    public static void run(String path, int loops) {
        RecordedScript script = new RecordedScript();
        BadLog log = script.start(path);
        for (int i = 0; i < loops; i++) {
            script.periodic(log);
        }
        log.flush();
    }

    private void run(String path) {
        run(path, 200);
    }

    private BadLog start(String path) {
        BadLog log = BadLog.init(path, false);
        BadLog.createValue("Match Number", "8");
        BadLog.createValue("Drivetrain/P", Double.toString(0.25));
        BadLog.createValue("Quote", "the \"best\" robot, \\o/");
        BadLog.createValue("Empty", "");
        BadLog.createValue("Control", "\b\f\n\r\t\u0001\u007f\u0085\u00a0\u2028\u20ac\u00fc");
        BadLog.createTopic("Drivetrain/Left/Output", "V", () -> number(0), "join:Drivetrain/Output", "hide");
        BadLog.createTopic("Drivetrain/Right/Output", "V", this::right, "join:Drivetrain/Output", "hide");
        BadLog.createTopic("Count", BadLog.UNITLESS, () -> (double) loop);
        BadLog.createTopic("Block", "A", () -> {
            double sum = 0;
            for (int i = 0; i < 5; i++) {
                sum += number(i);
            }
            return sum;
        }, "delta", "area");
        BadLog.createTopicStr("State", "ul", () -> loop % 3 == 0 ? "idle" : "moving, fast", "log");
        BadLog.createTopicStr("Nothing", "ul", () -> "");
        BadLog.createTopicSubscriber("Default", "°", DataInferMode.DEFAULT);
        BadLog.createTopicSubscriber("Last", "Ω", DataInferMode.LAST, "integrate");
        BadLog.createTopicSubscriber("Text", "ul", DataInferMode.LAST);
        log.finishInitialization();
        return log;
    }

    private void periodic(BadLog log) {
        if (loop % 2 == 1) {
            BadLog.publish("Default", number(7));
        }
        if (loop % 5 == 2) {
            BadLog.publish("Last", -1);
            BadLog.publish("Last", number(3));
        }
        if (loop % 7 == 3) {
            BadLog.publish("Text", "at " + loop + ", ready");
        }
        log.updateTopics();
        if (loop % 4 != 3) {
            log.log();
        }
        if (loop == 120) {
            log.setDoubleToStringFunction(value -> "<" + Math.round(value) + ">");
        }
        loop++;
    }

    private double right() {
        return number(11);
    }


    private double number(int offset) {
        return NUMBERS[(loop + offset) % NUMBERS.length];
    }
}
