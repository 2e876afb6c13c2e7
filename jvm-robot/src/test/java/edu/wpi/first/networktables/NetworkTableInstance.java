package edu.wpi.first.networktables;

/** Stands in for WPILib's class of this name, for the guides' robots. */
public final class NetworkTableInstance {
    private static final NetworkTableInstance DEFAULT = new NetworkTableInstance();

    private NetworkTableInstance() {}

    public static NetworkTableInstance getDefault() {
        return DEFAULT;
    }

    public DoubleTopic getDoubleTopic(String name) {
        return new DoubleTopic(name);
    }
}
