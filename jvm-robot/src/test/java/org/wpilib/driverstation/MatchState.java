package org.wpilib.driverstation;

/** Stands in for WPILib's class of that name, from season 2027 on. */
public final class MatchState {
    private MatchState() {
    }

    public enum MatchType {
        ELIMINATION
    }

    public static String getEventName() {
        return "ONTO";
    }

    public static MatchType getMatchType() {
        return MatchType.ELIMINATION;
    }

    public static int getMatchNumber() {
        return 7;
    }
}
