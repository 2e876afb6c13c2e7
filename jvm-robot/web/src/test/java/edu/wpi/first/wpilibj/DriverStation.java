package edu.wpi.first.wpilibj;

/** Stands in for WPILib's class of that name, up to season 2026. */
public final class DriverStation {
    public static volatile boolean enabled;
    public static volatile boolean attached;

    private DriverStation() {
    }

    public static boolean isEnabled() {
        return enabled;
    }

    public static boolean isFMSAttached() {
        return attached;
    }
}
