package badlog.lib

import java.lang.invoke.MethodHandle
import java.lang.invoke.MethodHandles
import java.lang.invoke.MethodType
import java.util.function.BooleanSupplier
import java.util.function.DoubleSupplier
import java.util.function.Supplier

/**
 * WPILib's information about the robot. Its classes are looked up at run time, because they moved: up to the 2026 season they are in
 * `edu.wpi.first`, from 2027 on in `org.wpilib`. If a class is not found, the robot counts as enabled and as not connected, and event,
 * match and battery voltage as unknown.
 */
internal class Wpilib private constructor(private val loader: ClassLoader?) {
    val isEnabled: BooleanSupplier = truth("isEnabled", DRIVER_STATION) ?: BooleanSupplier { true }

    val isDriverStationAttached: BooleanSupplier = truth("isDSAttached", DRIVER_STATION) ?: BooleanSupplier { false }

    val isClockSet: BooleanSupplier = truth("isSystemTimeValid", ROBOT_CONTROLLER)
        ?: BooleanSupplier { System.currentTimeMillis() > LONG_AGO_MILLIS }

    val batteryVoltage: DoubleSupplier? = handle("getBatteryVoltage", ROBOT_CONTROLLER)
        ?.asType(MethodType.methodType(Double::class.javaPrimitiveType))
        ?.let { handle -> DoubleSupplier { handle.invokeExact() as Double } }

    val event: Supplier<String> = handle("getEventName", MATCH_STATE).let { name ->
        Supplier { name?.invoke()?.toString() ?: "" }
    }

    val match: Supplier<String> = matchOf(handle("getMatchType", MATCH_STATE), handle("getMatchNumber", MATCH_STATE))

    private fun truth(method: String, classes: List<String>): BooleanSupplier? = handle(method, classes)
        ?.asType(MethodType.methodType(Boolean::class.javaPrimitiveType))
        ?.let { handle -> BooleanSupplier { handle.invokeExact() as Boolean } }

    private fun matchOf(type: MethodHandle?, number: MethodHandle?) = Supplier {
        // None, Practice, Qualification, Elimination.
        val letter = type?.invoke()?.toString()?.firstOrNull()?.uppercaseChar()
        if (letter == null || letter !in "PQE" || number == null) "" else "$letter${number.invoke()}"
    }

    /** Returns the static method of that name without parameters, in the first of [classes] that has it. */
    private fun handle(method: String, classes: List<String>): MethodHandle? {
        for (name in classes) {
            try {
                val found = Class.forName(name, false, loader).getMethod(method)
                return MethodHandles.publicLookup().unreflect(found)
            } catch (_: ReflectiveOperationException) {
                // Another season's name.
            } catch (_: LinkageError) {
                // Present but broken: treated as absent.
            }
        }
        return null
    }

    companion object {
        private val DRIVER_STATION = listOf(
            "edu.wpi.first.wpilibj.DriverStation",
            "org.wpilib.driverstation.RobotState",
            "org.wpilib.driverstation.DriverStation",
        )
        private val MATCH_STATE = listOf(
            "edu.wpi.first.wpilibj.DriverStation",
            "org.wpilib.driverstation.MatchState",
            "org.wpilib.driverstation.DriverStation",
        )
        private val ROBOT_CONTROLLER = listOf(
            "edu.wpi.first.wpilibj.RobotController",
            "org.wpilib.system.RobotController",
        )

        // The start of 2025, before this program existed: an earlier time means that the clock was never set.
        private const val LONG_AGO_MILLIS = 1_735_689_600_000L

        /** Searches [loader] without initializing any class. */
        fun find(loader: ClassLoader?): Wpilib = Wpilib(loader)
    }
}
