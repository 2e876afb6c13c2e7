@echo off
rem Starts @program@ with the Java of JAVA_HOME, or else with the one on the PATH. JAVA_OPTS gives Java more options.
setlocal
for %%i in ("%~dp0..") do set "lib=%%~fi\lib"
set "java=java.exe"
if defined JAVA_HOME set "java=%JAVA_HOME%\bin\java.exe"
where /q "%java%" 2>nul || if not exist "%java%" (
    echo @program@ needs Java 17 or newer, and %java% is not there: install it, or set JAVA_HOME. 1>&2
    exit /b 1
)
"%java%" @options@ "-XX:SharedArchiveFile=%lib%\@program@.jsa" %JAVA_OPTS% -cp "@classpath@" @main@ %*
exit /b %errorlevel%
