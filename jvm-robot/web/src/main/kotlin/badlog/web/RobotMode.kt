package badlog.web

import java.lang.invoke.MethodHandle
import java.lang.invoke.MethodHandles
import java.lang.invoke.MethodType
import java.util.function.BooleanSupplier

/**
 * The robot's mode according to WPILib, looked up at run time as in the logger. Robots that log with WPILib alone can therefore have the
 * server without the logger. Anything that is not found counts as false.
 */
internal class RobotMode private constructor(private val loader: ClassLoader?) {
    val isEnabled: BooleanSupplier = truth("isEnabled")

    val isFieldAttached: BooleanSupplier = truth("isFMSAttached")

    private fun truth(method: String): BooleanSupplier {
        val handle = CLASSES.firstNotNullOfOrNull { handle(it, method) } ?: return BooleanSupplier { false }
        return BooleanSupplier { handle.invokeExact() as Boolean }
    }

    private fun handle(name: String, method: String): MethodHandle? = try {
        val found = Class.forName(name, false, loader).getMethod(method)
        MethodHandles.publicLookup().unreflect(found).asType(MethodType.methodType(Boolean::class.javaPrimitiveType))
    } catch (_: ReflectiveOperationException) {
        // Another season's name.
        null
    } catch (_: LinkageError) {
        // Present but broken: treated as absent.
        null
    }

    companion object {
        private val CLASSES = listOf(
            "edu.wpi.first.wpilibj.DriverStation",
            "org.wpilib.driverstation.RobotState",
            "org.wpilib.driverstation.DriverStation",
        )

        /** Searches [loader] without initializing any class. */
        fun find(loader: ClassLoader?): RobotMode = RobotMode(loader)
    }
}
