/* SPDX-License-Identifier: MIT */
// Runs a light tree that is written in Python: python_tree.py, or the module that LIGHTCUTS_PYTHON
// names. Wants the library of Python, and not its headers:
//
//   cc -shared -fPIC -std=c99 -O2 -I oracle/include python_tree.c -o libpython_tree.so -ldl
//   export PYTHONPATH=oracle/example
//   lightcuts-oracle stress --cases 1000 --subject ./libpython_tree.so
//
// Python 3.11 unless LIGHTCUTS_LIBPYTHON says otherwise; the file's name is what
//   python3 -c 'import sysconfig; print(sysconfig.get_config_var("INSTSONAME"))'
// prints.

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>

#include <lightcuts/oracle/subject_abi.h>

static const char* setting(const char* name, const char* otherwise) {
  const char* value = getenv(name);
  return value != NULL ? value : otherwise;
}

const lightcuts_subject* lightcuts_subject_v1(void) {
  static lightcuts_subject subject;
  const char* module = setting("LIGHTCUTS_PYTHON", "python_tree");
  const char* file = setting("LIGHTCUTS_LIBPYTHON", "libpython3.11.so.1.0");
  void* python = dlopen(file, RTLD_NOW | RTLD_GLOBAL); // Python's own modules look there, too
  if (python == NULL) {
    fprintf(stderr, "%s\n", dlerror());
    return NULL;
  }
  void (*initialize)(int) = NULL;
  int (*run)(const char*) = NULL;
  *(void**)&initialize = dlsym(python, "Py_InitializeEx");
  *(void**)&run = dlsym(python, "PyRun_SimpleString");
  if (initialize == NULL || run == NULL) return NULL;
  initialize(0);
  char text[512];
  snprintf(text, sizeof text,
           "import sys; sys.dont_write_bytecode = True; import %s; %s.fill(%llu)", module, module,
           (unsigned long long)(size_t)&subject);
  return run(text) == 0 ? &subject : NULL;
}
