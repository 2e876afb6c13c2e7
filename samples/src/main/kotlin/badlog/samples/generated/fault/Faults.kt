package badlog.samples.generated.fault

/** All kinds of faults that can be planted. */
val FAULTS: List<Fault> = POWER_FAULTS + LINK_FAULTS + COMPUTER_FAULTS + CAN_FAULTS + DRIVE_FAULTS + LOCATION_FAULTS + MECHANISM_FAULTS +
    ARM_FAULTS + AIR_FAULTS

/** The strengths at which matches are generated: clear, medium and faint. */
val STRENGTHS: List<Double> = listOf(1.0, 0.65, 0.3)
