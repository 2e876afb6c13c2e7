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
include(":report")
include(":desktop-viewer")
include(":samples")
include(":benchmarks:jvm")
include(":benchmarks:node")
include(":benchmarks:robot")
include(":benchmarks:viewer")
