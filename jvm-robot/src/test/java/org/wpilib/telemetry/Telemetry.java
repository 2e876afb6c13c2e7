package org.wpilib.telemetry;

import java.util.Map;
import java.util.TreeMap;

/** Stands in for WPILib's class of this name, for the guides' robots: keeps the properties that it gets. */
public final class Telemetry {
    /** The properties of each name, as JSON texts. */
    public static final Map<String, Map<String, String>> PROPERTIES = new TreeMap<>();

    private Telemetry() {}

    public static void setProperty(String name, String key, String json) {
        PROPERTIES.computeIfAbsent(name, n -> new TreeMap<>()).put(key, json);
    }

    public static void log(String name, double value) {}
}
