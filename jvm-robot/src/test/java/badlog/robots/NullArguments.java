package badlog.robots;

import badlog.lib.BadLog;
import badlog.lib.DataInferMode;
import java.util.List;

/** Creates topics with arguments that Kotlin cannot express: null for a supplier or for an array of attributes. */
public final class NullArguments {
    private NullArguments() {
    }

    /** Returns how many of the functions refuse null. */
    public static int createAll() {
        String[] noArray = null;
        List<Runnable> creators = List.of(
            () -> BadLog.createTopic("A", "ul", null),
            () -> BadLog.createTopicStr("B", "ul", null),
            () -> BadLog.createTopicDouble("C", "ul", null),
            () -> BadLog.createTopicBoolean("F", "ul", null),
            () -> BadLog.createTopicLong("G", "ul", null),
            () -> BadLog.createTopicSubscriber("H", "ul", null),
            () -> BadLog.createTopic(null, "ul", () -> 1.0),
            () -> BadLog.createValue(null, "a"),
            () -> BadLog.createEvents(null),
            () -> BadLog.createTopic("D", "ul", () -> 1.0, noArray),
            () -> BadLog.createTopicSubscriber("E", "ul", DataInferMode.LAST, noArray));
        int refused = 0;
        for (Runnable creator : creators) {
            try {
                creator.run();
            } catch (NullPointerException expected) {
                refused++;
            }
        }
        return refused;
    }
}
