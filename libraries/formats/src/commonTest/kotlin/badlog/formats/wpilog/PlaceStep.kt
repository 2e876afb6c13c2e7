package badlog.formats.wpilog

import io.kotest.property.PropertyTesting

/** The step between the places of a file that a spec damages. The JVM tries each place; Node, with fewer random values, every fourth. */
internal val PLACE_STEP = maxOf(1, 100 / PropertyTesting.defaultIterationCount)
