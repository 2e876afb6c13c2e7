package badlog.robots;

import badlog.lib.BadLog;
import badlog.lib.DataInferMode;
import badlog.lib.DuplicateNameException;
import badlog.lib.InvalidModeException;
import badlog.lib.InvalidNameException;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.Supplier;

/** Calls the original's functions in every way that teams' programs do. Half of the test is that this compiles. */
public final class JavaRobot {
    private static BadLog log;
    private static final Supplier<Double> FIELD = () -> 4.0;

    private final Encoder encoder = new Encoder();
    private float current = 3.5f;

    public static void run(String path) {
        log = BadLog.init(path, Boolean.FALSE, Boolean.TRUE);
        JavaRobot robot = new JavaRobot();
        robot.createTopics();
        log.finishInitialization();
        log.setDoubleToStringFunction(robot::text);
        for (int i = 0; i < 3; i++) {
            robot.periodic();
        }
        log.flush();
    }

    private void createTopics() {
        String[] attributes = {"hide", "join:Arm"};
        BadLog.createTopic("Lambda", BadLog.UNITLESS, () -> 1.0);
        BadLog.createTopic("Block", "V", () -> {
            return 2.0;
        }, "hide");
        BadLog.createTopic("Overloaded", "m", encoder::getDistance, attributes);
        BadLog.createTopic("Cast", "A", () -> (double) current, "hide", "join:Arm");
        BadLog.createTopic("Count", "ul", () -> (double) encoder.count());
        BadLog.createTopic("Field", "s", FIELD);
        BadLog.createTopic("Static", "ul", JavaRobot::five);
        BadLog.createTopicStr("Text", "ul", () -> String.valueOf(encoder.count()), "log");
        BadLog.createTopicStr("Reference", "ul", encoder::toString);
        BadLog.createTopicSubscriber("Subscriber", "ul", DataInferMode.LAST, "log");
        BadLog.createValue("Version", System.getProperty("java.version"));
        try {
            BadLog.createValue("Text", "twice");
        } catch (DuplicateNameException | InvalidModeException | InvalidNameException expected) {
            BadLog.createValue("Caught", expected.getClass().getSimpleName());
        }
    }

    private void periodic() {
        BadLog.publish("Subscriber", "running");
        BadLog.publish("Subscriber", 6);
        BadLog.publish("Subscriber", (double) current);
        log.updateTopics();
        log.log();
    }

    private String text(Double value) {
        Function<Double, String> format = number -> String.format(Locale.ROOT, "%.2f", number);
        return format.apply(value);
    }

    private static double five() {
        return 5;
    }

    private static final class Encoder {
        double getDistance() {
            return 3;
        }

        @SuppressWarnings("unused")
        double getDistance(int side) {
            return side;
        }

        int count() {
            return 7;
        }

        @Override
        public String toString() {
            return "encoder";
        }
    }
}
