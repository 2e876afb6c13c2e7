pluginManagement {
    repositories {
        mavenCentral()
        gradlePluginPortal()
    }
}

dependencyResolutionManagement {
    repositories {
        mavenCentral()
        google {
            content {
                includeGroupByRegex("androidx\\..*")
            }
        }
    }
}

rootProject.name = "badlog"

include(":core")
include(":jvm-robot")
include(":html-export")
include(":command-line")
include(":expression")
include(":report")
include(":desktop-viewer")
include(":replay")
include(":samples")
include(":benchmarks:jvm")
include(":benchmarks:node")
include(":benchmarks:robot")
include(":benchmarks:viewer")
