package edu.wpi.first.wpilibj;

/** Stands in for WPILib's class of this name, for the guides' robots. */
public final class DataLogManager {
    private DataLogManager() {}

    public static void start() {}
}
