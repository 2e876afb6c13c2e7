package edu.wpi.first.networktables;

import java.util.Map;
import java.util.TreeMap;

/** Stands in for WPILib's class of this name, for the guides' robots: keeps the properties that it gets. */
public final class DoubleTopic {
    /** The properties of each name, as a JSON object. */
    public static final Map<String, String> PROPERTIES = new TreeMap<>();

    private final String name;

    DoubleTopic(String name) {
        this.name = name;
    }

    public void setProperties(String json) {
        PROPERTIES.put(name, json);
    }

    public DoublePublisher publish() {
        return value -> {};
    }
}
