package edu.wpi.first.wpilibj;

/** Stands in for WPILib's class of that name, up to season 2026. */
public final class DriverStation {
    public static boolean enabled;
    public static boolean attached;
    public static String event = "";
    public static MatchType matchType = MatchType.None;
    public static int matchNumber;

    private DriverStation() {
    }

    public enum MatchType {
        None, Practice, Qualification, Elimination
    }

    public static boolean isEnabled() {
        return enabled;
    }

    public static boolean isDSAttached() {
        return attached;
    }

    public static String getEventName() {
        return event;
    }

    public static MatchType getMatchType() {
        return matchType;
    }

    public static int getMatchNumber() {
        return matchNumber;
    }
}
