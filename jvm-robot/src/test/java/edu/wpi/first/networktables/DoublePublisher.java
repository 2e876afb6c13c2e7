package edu.wpi.first.networktables;

/** Stands in for WPILib's interface of this name, for the guides' robots. */
public interface DoublePublisher {
    void set(double value);
}
